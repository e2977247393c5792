#include "ramify/draw/label_text.hpp"

#include <algorithm>

#include "ramify/core/utf8.hpp"

namespace ramify {
namespace {

/// The bytes of the UTF-8 character that the text begins with; 0 where it begins with none. Forms that are
/// too long and surrogates are none (RFC 3629).
std::size_t character_bytes(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = first < 0x80   ? 1
                            : first < 0xc2 ? 0
                            : first < 0xe0 ? 2
                            : first < 0xf0 ? 3
                            : first < 0xf5 ? 4
                                           : 0;
  if (bytes < 2) return bytes;
  if (text.size() < bytes || std::ranges::any_of(text.substr(1, bytes - 1), begins_character)) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool is_too_long = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return is_too_long || is_no_character ? 0 : bytes;
}

}  // namespace

std::string label_text(std::string_view name, std::size_t longest) {
  std::string text;
  std::size_t written = 0;
  while (!name.empty()) {
    if (++written > longest) return text + "…";
    const std::size_t bytes = character_bytes(name);
    if (bytes == 0)
      text += '?';
    else if (bytes == 1 && (static_cast<unsigned char>(name[0]) < 0x20 || name[0] == 0x7f))
      text += ' ';
    else
      text += name.substr(0, bytes);
    name.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return text;
}

}  // namespace ramify
