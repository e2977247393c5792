#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/config/replicate_rule.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {

/// The seed of a config that names none: the year of the thesis.
inline constexpr std::uint64_t default_seed = 1996;

/// Every model with every size: a block of cells of a run.
struct SizeGroup {
  std::vector<Model> models;
  std::vector<Size> sizes;
  ReplicateRule replicates;
};

/// What a run does, as its TOML file says (docs/config.md). Groups hold no cell twice, no size that a model
/// cannot draw and none without replicates.
struct RunConfig {
  std::string path;                  ///< the file, or the name given for the text
  std::string text;                  ///< its content, for provenance
  std::optional<std::string> claim;  ///< "C20" or "C6 C7"; nothing for a free run
  std::uint64_t seed = default_seed;
  StatisticSet statistics;
  bool graft = true;
  std::vector<SizeGroup> groups;
};

/// The name of its file without the folder: what a page calls it, the same wherever it lies.
std::string file_name(const RunConfig& config);

/// Throws Error "file:line:column: problem (why): what to do" for anything that docs/config.md does not
/// allow.
RunConfig read_run_config(const std::filesystem::path& path);

/// The same from text; name stands for the file in errors.
RunConfig parse_run_config(std::string_view text, std::string_view name);

}  // namespace ramify
