#pragma once

#include <filesystem>
#include <string>

namespace ramify::cli {

/// A folder of configs/: that of --configs where it is given, of the working directory, or of the place
/// ramify was built or installed from. Throws Error where there is none.
std::filesystem::path config_folder(const std::string& given, const std::string& name);

}  // namespace ramify::cli
