#include "ramify/config/run_config.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

#include <fmt/format.h>

#include "ramify/config/run_grid.hpp"
#include "ramify/config/toml_value.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

using detail::Expected;
using detail::Placed;
using detail::TomlTable;
using detail::TomlValue;

constexpr std::array<std::string_view, 8> config_keys{"claim",      "seed",       "models", "n",
                                                      "replicates", "statistics", "graft",  "cells"};
constexpr std::array<std::string_view, 3> group_keys{"models", "n", "replicates"};

constexpr Expected claim_wanted{"the number of a claim", "claim = \"C20\""};
constexpr Expected seed_wanted{"a whole number", "seed = 1996"};
constexpr Expected graft_wanted{"true or false", "graft = true"};
constexpr Expected statistics_wanted{"a list of statistics", "statistics = [\"strahler\", \"height\"]"};
constexpr Expected cells_wanted{"a list of tables", "[[cells]] before the keys of each group"};

StatisticSet read_statistics(const TomlValue& statistics) {
  StatisticSet set;
  std::vector<std::string> names;
  for (const auto& element : statistics.elements(statistics_wanted)) {
    names.push_back(element.text(statistics_wanted));
    set = at_place(element, [&] { return StatisticSet::parse(names); });
  }
  return set;
}

/// The groups of a config, from its own keys or from its [[cells]], and no cell twice.
class GroupReader {
 public:
  GroupReader(std::string_view file, const TomlTable& defaults) : file_(file), defaults_(defaults) {}

  std::vector<SizeGroup> read() {
    const auto cells = defaults_.find("cells");
    if (!cells) return {read_group(defaults_)};
    std::vector<SizeGroup> groups;
    for (const auto& element : cells->elements(cells_wanted)) {
      const TomlTable own(file_, element.table(cells_wanted));
      own.require_known("a [[cells]] table", group_keys);
      groups.push_back(read_group(own));
    }
    require_defaults_used();
    return groups;
  }

 private:
  SizeGroup read_group(const TomlTable& own) {
    const auto models = detail::read_models(pick(own, "models"));
    const auto sizes = detail::read_sizes(pick(own, "n"));
    const ReplicateRule rule = detail::read_replicates(pick(own, "replicates"));
    SizeGroup group{{}, {}, rule};
    for (const auto& size : sizes) group.sizes.push_back(size.value);
    for (const auto& model : models) {
      group.models.push_back(model.value);
      for (const auto& size : sizes) check_cell(model, size, rule);
    }
    return group;
  }

  /// The group's own value, else the one it inherits.
  TomlValue pick(const TomlTable& own, std::string_view key) {
    if (auto value = own.find(key)) return *std::move(value);
    used_.emplace(key);
    if (auto value = defaults_.find(key)) return *std::move(value);
    throw error_at({std::string(file_), 0, 0}, fmt::format("no '{}'", key),
                   "a run needs models, n and replicates", "add it; docs/config.md has an example");
  }

  void check_cell(const Placed<Model>& model, const Placed<Size>& size, const ReplicateRule& rule) {
    at_place(size.place, [&] {
      model.value.require_size(size.value);
      rule.count(size.value);
    });
    if (!seen_.insert(model.value.stream_cell(size.value)).second)
      size.place.fail(fmt::format("{} with n = {} twice", model.value.text(), size.value),
                      "the same cell would draw the same trees again", "remove one of them");
  }

  /// A value that every [[cells]] table overrides looks as if it did something.
  void require_defaults_used() const {
    for (const auto key : group_keys) {
      const auto value = defaults_.find(key);
      if (value && !used_.contains(std::string(key)))
        value->fail(fmt::format("'{}' outside [[cells]] is not used", key),
                    "every [[cells]] table has its own",
                    "remove it, or add a [[cells]] table that inherits it");
    }
  }

  std::string_view file_;
  TomlTable defaults_;
  std::set<std::string> used_;
  std::set<std::uint64_t> seen_;  // what keys the streams of a cell: equal for equal models and sizes
};

}  // namespace

std::string file_name(const RunConfig& config) {
  return std::filesystem::path(config.path).filename().string();
}

RunConfig parse_run_config(std::string_view text, std::string_view name) {
  const toml::table document = detail::parse_toml(text, name);
  const TomlTable keys(name, document);
  keys.require_known("a config", config_keys);
  RunConfig config;
  config.path = name;
  config.text = text;
  if (const auto claim = keys.find("claim")) config.claim = claim->text(claim_wanted);
  if (const auto seed = keys.find("seed")) config.seed = seed->whole(0, INT64_MAX, seed_wanted);
  if (const auto graft = keys.find("graft")) config.graft = graft->boolean(graft_wanted);
  const auto statistics = keys.find("statistics");
  if (!statistics)
    throw error_at({std::string(name), 0, 0}, "no 'statistics'", "a run needs something to measure",
                   fmt::format("add {}", statistics_wanted.example));
  config.statistics = read_statistics(*statistics);
  config.groups = GroupReader(name, keys).read();
  return config;
}

RunConfig read_run_config(const std::filesystem::path& path) {
  return parse_run_config(read_text_file(path), path.string());
}

}  // namespace ramify
