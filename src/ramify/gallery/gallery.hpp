#pragma once

#include <filesystem>

#include "ramify/core/cancellation.hpp"

namespace ramify {

/// Draws every preset into a new folder: NAME.svg, a thumbnail of each, index.html with titles, sources and
/// the command of each, and contact-sheet.png, all of them on one page. The folder appears whole or not at
/// all.
///
/// @param presets  the folder of their files
/// Throws Error where the folder exists or cannot be made, where a preset is not right; Interrupted.
void draw_gallery(const std::filesystem::path& folder, const std::filesystem::path& presets,
                  const Cancellation& cancellation);

}  // namespace ramify
