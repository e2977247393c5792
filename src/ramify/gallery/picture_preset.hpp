#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/draw/tree_look.hpp"
#include "ramify/model/model.hpp"
#include "ramify/shape/limb_walk.hpp"
#include "ramify/shape/shape_rules.hpp"

namespace ramify {

/// One tree of a picture: which tree, its form, how it is drawn.
struct PicturePanel {
  std::string caption;
  Model model;
  Size n;
  std::uint64_t seed, replicate;
  ShapeRules rules;
  TreeLook look;
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::optional<LimbWalk> walk = {};
};

/// A picture of the sources as a file of configs/draw says it: rules and constants (docs/draw.md).
struct PicturePreset {
  std::string file;
  std::string name;  ///< of the file, without its ending
  std::string title;
  std::string source;  ///< author, year, figure; entry of the catalogue
  std::string note;    ///< what the source leaves open and was chosen here; may be empty
  std::size_t columns;
  std::vector<PicturePanel> panels;  ///< one at least
};

/// What a command line puts in the place of a preset's own.
struct PresetChange {
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  std::optional<Size> n = {};
  std::optional<std::uint64_t> seed = {}, replicate = {};
  std::string view = {};
  std::string style = {};     ///< lines, bars or branches
  std::string color_by = {};  ///< bark or order
  // NOLINTEND(readability-redundant-member-init)
};

/// Throws Error with the place for a syntax error, a key, rule, constant or value that does not exist,
/// nearest names given; for a model or size that does not.
/// @param name  of the file, for errors and as the preset's own
PicturePreset parse_picture_preset(std::string_view text, const std::filesystem::path& name);

/// Presets of a folder by name, in order. Throws Error where there is no such folder.
std::vector<std::string> picture_preset_names(const std::filesystem::path& folder);

/// Throws Error for an unknown name, nearest names given.
PicturePreset find_picture_preset(const std::filesystem::path& folder, const std::string& name);

/// Throws Error where it does not go with the preset.
void change(PicturePreset& preset, const PresetChange& changes);

/// The views of a sheet (G11): from above, oblique, from the front and from the right.
const std::vector<std::string>& sheet_views();

/// In the place of its one tree that tree in the views of a sheet. Throws Error where it shows more than one.
void show_in_sheet_views(PicturePreset& preset);

}  // namespace ramify
