#pragma once

#include <string_view>
#include <vector>

#include "ramify/config/toml_value.hpp"
#include "ramify/gallery/picture_preset.hpp"

namespace ramify::detail {

/// The panels of a preset: one of its own keys, or those of its [[panel]] tables, each of which inherits what
/// it does not say. Throws Error with the place.
std::vector<PicturePanel> read_panels(std::string_view file, const TomlTable& preset);

/// The keys that a panel may have, which the preset has too.
std::span<const std::string_view> panel_keys();

}  // namespace ramify::detail
