#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ramify/draw/leaf_outline.hpp"
#include "ramify/draw/view.hpp"

namespace ramify {

/// Leaves at the external nodes of a picture.
struct LeafLook {
  LeafForm form;
  double length = 0.02;  ///< of a blade, as part of the picture's larger side
  Color color{0.25, 0.5, 0.18};
  bool is_autumn = false;  ///< colours by depth: lighter the deeper (G18), from dark red to yellow
};

/// How a form is drawn.
struct TreeLook {
  enum class Style : std::uint8_t {
    lines,     ///< of one width, whatever the radius
    bars,      ///< tapered rectangles
    branches,  ///< tapered branches with smooth forks
  };

  Style style = Style::branches;
  View view;
  bool by_order = false;  ///< colours by Horton-Strahler order instead of bark
  Color bark{0.36, 0.25, 0.17};
  bool tapers = true;     ///< a branch ends as wide as its widest child begins
  double line_width = 1;  ///< of lines, in the unit of the page
  double shade = 0.35;    ///< how much paler the farthest branch is than the nearest
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::optional<LeafLook> leaves = {};
  bool fills_notches = false;  ///< of bars: between a branch's end and where its children begin (G2)
  /// Of a measured tree: external nodes are wood; else they are leaves, or nothing.
  bool tips_are_branches = false;
  bool has_blossoms = false;  ///< in place of the leaves of a node that bears two (G8)
  bool has_fruit = false;     ///< the same
  bool has_needles = false;   ///< along every branch (G9)
  bool has_shadow = false;    ///< on the ground, of a lamp over the left (G21)
};

/// Throws Error for another name, nearest names given.
TreeLook::Style parse_tree_style(const std::string& name);

/// Whether branches are coloured by their order: "bark" or "order". Throws Error for another name.
bool parse_color_by(const std::string& name);

}  // namespace ramify
