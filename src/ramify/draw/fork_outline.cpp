#include "ramify/draw/fork_outline.hpp"

#include <algorithm>

#include "ramify/draw/page_vector.hpp"

namespace ramify {
namespace {

/// A way that points at who looks has no direction on the page: any will do.
PagePoint direction(PagePoint way) {
  const double far = length(way);
  return far > 1e-9 ? way * (1 / far) : PagePoint{0, -1};
}

PagePoint direction(const PageLimb& limb) {
  return direction(limb.end - limb.start);
}

/// As long as the wider of the two asks, never more than half the branch.
double bud_length(const PageLimb& limb) {
  const double whole = length(limb.end - limb.start);
  return std::min(0.5 * whole, std::max(3 * limb.start_radius, 0.3 * whole));
}

}  // namespace

void add_bar(Patches& patches, const Color& color, const PageLimb& limb) {
  add_notched_bar(patches, color, limb, {});
}

void add_ribbon(Patches& patches, const Color& color, std::span<const PagePoint> line, double start_radius,
                double end_radius) {
  const std::size_t last = line.size() - 1;
  const auto side = [&](std::size_t i) {
    const PagePoint way = line[std::min(i + 1, last)] - line[i == 0 ? 0 : i - 1];
    const double part = static_cast<double>(i) / static_cast<double>(last);
    return to_the_left(direction(way)) * (start_radius + part * (end_radius - start_radius));
  };
  patches.begin(color, line[0] + side(0));
  for (std::size_t i = 1; i <= last; ++i) patches.line(line[i] + side(i));
  for (std::size_t i = last + 1; i-- > 0;) patches.line(line[i] - side(i));
}

void add_notched_bar(Patches& patches, const Color& color, const PageLimb& limb,
                     std::span<const PageLimb> children) {
  const PagePoint left = to_the_left(direction(limb));
  patches.begin(color, limb.start + left * limb.start_radius);
  patches.line(limb.end + left * limb.end_radius);
  for (const PageLimb& child : children) {
    const PagePoint along = direction(child), side = to_the_left(along) * child.start_radius;
    const double lap = std::min(0.25 * child.start_radius, 0.5 * length(child.end - child.start));
    patches.line(child.start + along * lap + side);
    patches.line(child.start + along * lap - side);
  }
  patches.line(limb.end - left * limb.end_radius);
  patches.line(limb.start - left * limb.start_radius);
}

PagePoint bud_end(const PageLimb& limb) {
  return limb.start + direction(limb) * bud_length(limb);
}

PagePoint own_start(const PageLimb& limb) {
  const double bud = bud_length(limb);
  return limb.start + direction(limb) * (bud - std::min(0.25 * bud, 0.5 * limb.start_radius));
}

void add_fork(Patches& patches, const Color& color, const PageLimb& limb, PagePoint from,
              std::span<const PageLimb> children) {
  const PagePoint h = direction(limb), left = to_the_left(h);
  // The sides bend a little before the end, so that the fork is no edge.
  const double room = length(limb.end - from), bend = std::min(0.4 * room, 1.5 * limb.end_radius);
  const PagePoint neck = children.empty() ? limb.end : limb.end - h * bend;
  PagePoint handle = neck + left * limb.end_radius + h * bend;
  patches.begin(color, from + left * limb.start_radius);
  patches.line(neck + left * limb.end_radius);
  for (const PageLimb& child : children) {
    const PagePoint along = direction(child), side = to_the_left(along) * child.start_radius;
    // Sides leave the child's own three radii out: from a longer bud's end they would span a web.
    const double out = std::min(bud_length(child), 3 * child.start_radius);
    const PagePoint shoulder = child.start + along * out, tip = bud_end(child), back = along * (-0.8 * out);
    patches.curve(handle, shoulder + side + back, shoulder + side);
    patches.line(tip + side);
    patches.line(tip - side);
    patches.line(shoulder - side);
    handle = shoulder - side + back;
  }
  const PagePoint right = neck - left * limb.end_radius;
  if (children.empty())
    patches.line(right);
  else
    patches.curve(handle, right + h * bend, right);
  patches.line(from - left * limb.start_radius);
}

void add_disc(Patches& patches, const Color& color, PagePoint middle, double radius) {
  constexpr double handle = 0.5522847498;  // of four curves that make a circle to 3 parts in 10,000
  const double k = handle * radius;
  const auto at = [&](double x, double y) { return PagePoint{middle.x + x, middle.y + y}; };
  patches.begin(color, at(radius, 0));
  patches.curve(at(radius, k), at(k, radius), at(0, radius));
  patches.curve(at(-k, radius), at(-radius, k), at(-radius, 0));
  patches.curve(at(-radius, -k), at(-k, -radius), at(0, -radius));
  patches.curve(at(k, -radius), at(radius, -k), at(radius, 0));
}

}  // namespace ramify
