#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace ramify {

/// Whether a byte of a UTF-8 text begins a character: all but 10xxxxxx do.
constexpr bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0) != 0x80;
}

/// Characters, not bytes, of a UTF-8 text.
constexpr std::size_t character_count(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

}  // namespace ramify
