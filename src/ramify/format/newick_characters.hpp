#pragma once

#include <array>
#include <cstdint>

namespace ramify::detail {

/// What a character is in Newick.
enum class NewickKind : std::uint8_t { word, blank, mark };

constexpr std::array<NewickKind, 256> newick_kinds() {
  std::array<NewickKind, 256> table{};
  for (const char c : {' ', '\t', '\n', '\r', '\v', '\f'})
    table[static_cast<unsigned char>(c)] = NewickKind::blank;
  for (const char c : {'(', ')', '[', ']', ':', ';', ',', '{', '\0'})
    table[static_cast<unsigned char>(c)] = NewickKind::mark;
  return table;
}

inline NewickKind newick_kind(char c) {
  static constexpr auto table = newick_kinds();
  return table[static_cast<unsigned char>(c)];
}

}  // namespace ramify::detail
