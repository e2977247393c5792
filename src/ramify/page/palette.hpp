#pragma once

#include <string_view>

namespace ramify {

/// The colours of a page in one theme, hexadecimal as CSS has them. text, muted, link and the tones good, bad
/// and open are read on back and on soft: each pair has a contrast of 4.5 or more, (L1 + 0.05)/(L2 + 0.05) of
/// relative luminances (WCAG 2.1, 1.4.3).
struct PagePalette {
  std::string_view text, muted, link;
  std::string_view back;  ///< of the page
  std::string_view soft;  ///< of tables' heads and commands
  std::string_view rule;  ///< lines, which are not read
  std::string_view good, bad, open;
};

inline constexpr PagePalette light_palette{"#1b212c", "#4a5464", "#0a55a3", "#ffffff", "#f1f4f8",
                                           "#c5ccd6", "#17663a", "#a81f2d", "#7a4f00"};
inline constexpr PagePalette dark_palette{"#e7eaf0", "#aeb7c6", "#8fc4ff", "#14171d", "#20262f",
                                          "#434c5b", "#7edca0", "#ff9f98", "#f0c268"};

}  // namespace ramify
