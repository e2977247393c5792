#pragma once

#include <string>
#include <string_view>

namespace ramify {

/// A text as JSON writes it, in quotes. JSON is UTF-8: bytes that are not are replaced by U+FFFD.
std::string json_text(std::string_view text);

}  // namespace ramify
