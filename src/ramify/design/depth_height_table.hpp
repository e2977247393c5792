#pragma once

#include "ramify/design/depth_curve.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// model, a, b, depth, height of every beta(a,b), a <= b, of the curve's depth and this height.
///
/// Throws Error where there is none, with the heights that the depth allows and the nearest of them.
Table depth_height_table(const DepthCurve& curve, double height);

/// The same columns along the curve, from beta(a,a) on.
Table depth_curve_table(const DepthCurve& curve);

}  // namespace ramify
