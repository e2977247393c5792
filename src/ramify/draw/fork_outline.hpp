#pragma once

#include <span>

#include "ramify/draw/drawing.hpp"

namespace ramify {

/// A branch as it lies on the page.
struct PageLimb {
  PagePoint start, end;
  double start_radius, end_radius;
};

/// A deformed rectangle (G1): the branch by itself.
void add_bar(Patches& patches, const Color& color, const PageLimb& limb);

/// A branch that goes from place to place: as broad there as a bar on the way would be.
/// @param line  two places at least, from its start to its end
void add_ribbon(Patches& patches, const Color& color, std::span<const PagePoint> line, double start_radius,
                double end_radius);

/// A bar with the notches between its end and those of its children, small triangles of its colour (G2;
/// Viennot et al. 1989): its outline goes from corner to corner of their ends, and a quarter of a radius
/// under the children, so that no seam shows.
/// @param children  from the left to the right of who goes up the branch
void add_notched_bar(Patches& patches, const Color& color, const PageLimb& limb,
                     std::span<const PageLimb> children);

/// Where a branch leaves the smooth unit that its mother's end is, and its own begins.
PagePoint bud_end(const PageLimb& limb);

/// Where its own outline begins: a little before that, so that no seam shows between the two.
PagePoint own_start(const PageLimb& limb);

/// A branch from `from` on with the buds of its children as one smooth outline (G4; Devroye and Kruszewski
/// 1995): sides run into each other, crotches are rounded.
/// @param children  from the left to the right of who goes up the branch
void add_fork(Patches& patches, const Color& color, const PageLimb& limb, PagePoint from,
              std::span<const PageLimb> children);

/// A disc.
void add_disc(Patches& patches, const Color& color, PagePoint middle, double radius);

}  // namespace ramify
