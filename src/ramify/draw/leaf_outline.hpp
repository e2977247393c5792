#pragma once

#include <string>
#include <vector>

#include "ramify/draw/drawing.hpp"

namespace ramify {

/// The form of a leaf: how its blade ends and begins (G6; nine apices and four bases as Devroye and
/// Kruszewski 1995 have them after Sugden 1984, drawn anew: their outlines are lost).
struct LeafForm {
  enum class Apex : std::uint8_t {
    acuminate,   ///< drawn out into a tip
    acute,       ///< sharp
    cuspidate,   ///< suddenly a stiff point
    mucronate,   ///< rounded, with a small spine
    obtuse,      ///< blunt
    rounded,     ///< half a circle
    truncate,    ///< as if cut off
    retuse,      ///< with a shallow notch
    emarginate,  ///< with a deep one
  };
  enum class Base : std::uint8_t {
    cuneate,  ///< a wedge
    rounded,
    cordate,  ///< a heart
    truncate,
  };

  enum class Margin : std::uint8_t {
    entire,  ///< from the base to the apex without a break
    lobed,   ///< a simple oak leaf (E22): three round lobes on either side and one at the tip; it has neither
             ///< base nor apex of its own choice
  };

  Apex apex = Apex::acute;
  Base base = Base::rounded;
  double width = 0.5;  ///< of the blade, its length being 1
  Margin margin = Margin::entire;
};

/// Throw Error for another name, nearest names given.
LeafForm::Apex parse_apex(const std::string& name);
LeafForm::Base parse_base(const std::string& name);
LeafForm::Margin parse_margin(const std::string& name);

/// A leaf as one patch: from its foot along a vector that is as long as the blade.
void add_leaf(Patches& patches, const LeafForm& form, const Color& color, PagePoint foot, PagePoint blade);

}  // namespace ramify
