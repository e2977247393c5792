#include "ramify/config/run_grid.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "ramify/config/size_grid.hpp"
#include "ramify/core/number.hpp"

namespace ramify::detail {
namespace {

constexpr Expected models_wanted{"a list of models", "models = [\"bst\", \"beta(10,80)\"]"};
constexpr Expected sizes_wanted{"a list of whole numbers or a grid",
                                "n = [100, 1000] or n = { from = 100, to = 1_000_000, count = 9 }"};
constexpr Expected size_wanted{"a whole number", "n = [100, 1000]"};
constexpr Expected from_wanted{"a whole number", "from = 100"};
constexpr Expected to_wanted{"a whole number", "to = 1_000_000"};
constexpr Expected count_wanted{"a whole number", "count = 9"};
constexpr Expected factor_wanted{"a number above 1 or a fraction", "factor = 4 or factor = \"1/0.23\""};
constexpr Expected replicates_wanted{"a whole number or a table of them",
                                     "replicates = 2000 or replicates = { to_1e5 = 2000, above = 100 }"};
constexpr Expected trees_wanted{"a whole number", "a number of trees, such as 2000"};

constexpr std::uint64_t most_trees = INT64_MAX;
constexpr std::string_view bound_prefix = "to_";

TomlValue require_key(const TomlTable& table, const TomlValue& owner, std::string_view key,
                      const Expected& expected) {
  if (auto value = table.find(key)) return *std::move(value);
  owner.fail(fmt::format("{} without '{}'", owner.key(), key),
             "a grid is { from, to, count } or { from, factor, count }",
             fmt::format("add {}", expected.example));
}

std::vector<Size> read_grid(const TomlValue& n) {
  static constexpr std::array<std::string_view, 4> keys{"from", "to", "factor", "count"};
  const TomlTable grid(n.file(), n.table(sizes_wanted));
  grid.require_known("a grid of n", keys);
  const Size from = require_key(grid, n, "from", from_wanted).whole(1, max_size, from_wanted);
  const auto count = require_key(grid, n, "count", count_wanted).whole(1, max_grid_sizes, count_wanted);
  const auto factor = grid.find("factor");
  if (!factor) {
    const Size to = require_key(grid, n, "to", to_wanted).whole(1, max_size, to_wanted);
    return at_place(n, [&] { return geometric_grid(from, to, count); });
  }
  if (const auto to = grid.find("to"))
    to->fail("a grid with both 'to' and 'factor'", "either one fixes the other", "keep one of them");
  const double ratio = factor->real(factor_wanted);
  return at_place(*factor, [&] { return scaled_grid(from, ratio, count); });
}

Size read_bound(const TomlValue& entry) {
  const std::string& key = entry.key();
  const auto bound = key.starts_with(bound_prefix)
                         ? parse_count(std::string_view(key).substr(bound_prefix.size()))
                         : std::nullopt;
  if (bound && *bound >= 1 && *bound <= max_size) return *bound;
  entry.fail(fmt::format("unknown key '{}' in replicates", key),
             "its keys are above and to_N with N from 1 to 2^62", "write it like to_1e5, to_1000 or above");
}

}  // namespace

std::vector<Placed<Model>> read_models(const TomlValue& models) {
  std::vector<Placed<Model>> placed;
  for (auto& element : models.elements(models_wanted)) {
    const std::string text = element.text(models_wanted);
    placed.push_back({at_place(element, [&] { return Model::parse(text); }), element});
  }
  return placed;
}

std::vector<Placed<Size>> read_sizes(const TomlValue& n) {
  std::vector<Placed<Size>> placed;
  if (n.is_table()) {
    for (const Size size : read_grid(n)) placed.push_back({size, n});
    return placed;
  }
  for (auto& element : n.elements(sizes_wanted))
    placed.push_back({element.whole(1, max_size, size_wanted), element});
  return placed;
}

ReplicateRule read_replicates(const TomlValue& replicates) {
  ReplicateRule rule;
  if (replicates.is_number()) {
    rule.above = replicates.whole(1, most_trees, replicates_wanted);
    return rule;
  }
  const TomlTable table(replicates.file(), replicates.table(replicates_wanted));
  for (const auto& entry : table.values()) {
    const std::uint64_t trees = entry.whole(1, most_trees, trees_wanted);
    if (entry.key() == "above") {
      rule.above = trees;
      continue;
    }
    const Size bound = read_bound(entry);
    const auto same = [bound](const auto& other) { return other.first == bound; };
    if (std::any_of(rule.up_to.begin(), rule.up_to.end(), same))
      entry.fail(fmt::format("'{}' bounds n at {} again", entry.key(), bound), "each bound is given once",
                 "remove one of them");
    rule.up_to.emplace_back(bound, trees);
  }
  std::sort(rule.up_to.begin(), rule.up_to.end());
  return rule;
}

}  // namespace ramify::detail
