#pragma once

#include <filesystem>
#include <string>

namespace ramify {

/// The bytes of a file. Throws Error where it is absent, a folder or unreadable.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace ramify
