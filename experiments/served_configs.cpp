#include "served_configs.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

namespace fs = std::filesystem;

std::vector<fs::path> config_files(const fs::path& folder) {
  std::error_code reason;
  const fs::directory_iterator entries(folder, reason);
  if (reason)
    throw Error(fmt::format("no configs in '{}'", folder.string()), reason.message(),
                "name a folder that has quick/ and full/ with --configs");
  std::vector<fs::path> files;
  for (const auto& entry : entries)
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::vector<RunConfig> read_configs(const std::vector<fs::path>& files, std::optional<std::uint64_t> seed) {
  std::vector<RunConfig> configs;
  std::set<fs::path> stems;
  for (const auto& file : files) {
    RunConfig& config = configs.emplace_back(read_run_config(file));
    served_claims(config);
    if (seed) config.seed = *seed;
    if (!stems.insert(file.stem()).second)
      throw Error(fmt::format("config '{}'", file.string()),
                  "another config has the same file name, and so the same folder",
                  "run them with different --out");
  }
  return configs;
}

std::vector<RunConfig> serving(std::vector<RunConfig> configs, const std::vector<const Claim*>& claims) {
  if (claims.empty()) return configs;
  const auto is_asked_for = [&](const Claim* claim) {
    return std::ranges::find(claims, claim) != claims.end();
  };
  std::erase_if(configs, [&](const RunConfig& config) {
    return std::ranges::none_of(served_claims(config), is_asked_for);
  });
  return configs;
}

}  // namespace ramify
