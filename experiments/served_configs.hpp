#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "claim.hpp"

namespace ramify {

/// The *.toml of a folder, by name. Throws Error where it cannot be read.
std::vector<std::filesystem::path> config_files(const std::filesystem::path& folder);

/// Reads configs, with a seed in place of their own where one is given. Throws Error where a config lacks
/// what its claims need, and for two configs of one name, which would share a folder.
std::vector<RunConfig> read_configs(const std::vector<std::filesystem::path>& files,
                                    std::optional<std::uint64_t> seed);

/// Those that serve one of the claims; all where no claim is given.
std::vector<RunConfig> serving(std::vector<RunConfig> configs, const std::vector<const Claim*>& claims);

}  // namespace ramify
