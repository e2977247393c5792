#pragma once

#include <string>
#include <string_view>

namespace ramify {

/// The bytes begin like a gzip file.
bool is_gzip(std::string_view bytes);

/// What a gzip file of one or more members holds. Throws Error where it is damaged or cut off.
/// @param name  for messages
std::string gunzip(std::string_view bytes, std::string_view name);

}  // namespace ramify
