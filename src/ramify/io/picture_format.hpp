#pragma once

#include <filesystem>
#include <string_view>

namespace ramify {

enum class PictureFormat { svg, png };

/// The format that a file's name ends in. Throws Error for another ending.
/// @param option  that names the file: "--plot"
/// @param what    is put into it: "pictures"
PictureFormat picture_format(const std::filesystem::path& path, std::string_view option,
                             std::string_view what);

}  // namespace ramify
