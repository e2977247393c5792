#pragma once

#include <optional>
#include <vector>

#include "ramify/optimise/scanned_curve.hpp"
#include "ramify/theory/beta_split.hpp"

namespace ramify {

/// An end of the heights that beta trees of one depth have.
struct HeightEnd {
  double height;
  std::optional<BetaSplit> split;  ///< that has it; nothing: a limit that none within the domain reaches
};

struct HeightRange {
  HeightEnd lowest, highest;
};

/// All beta(a,b), a <= b, of one depth constant D (depth_constant.hpp): a curve from beta(a,a) on, along
/// which b grows, a/b falls, and a and b together come to stand for one fraction x, whose entropy is 1/D: the
/// curve ends at split(x), which has the same depth.
///
/// Depth falls in a and in b, so that D and b give a. The height constant (height_constant.hpp) along the
/// curve is a smooth function of b with up to two extrema beyond beta(a,a), itself one; it nears its end from
/// above. beta(a,a) and beta(a,a+1) share every constant of the unordered split. Kruszewski 1996, 2.5.2 (H6)
/// has a and b follow from depth and height: they may do so several times, or not at all (X68).
class DepthCurve {
 public:
  /// @param depth  above 1/log 2, to 1e8
  /// Throws Error for a depth that no beta tree within the domain of a and b has; Interrupted. Cost: half a
  /// second on one core.
  DepthCurve(double depth, const ScanEffort& effort);

  double depth() const { return depth_; }

  /// Of the curve, from beta(a,a) to the largest b.
  std::vector<BetaSplit> splits() const;

  /// What all heights of the curve lie between.
  HeightRange heights() const;

  /// Every beta(a,b), a <= b, of this depth and height, ascending in b; a and b to 12 digits.
  std::vector<BetaSplit> with_height(double height) const;

  /// The smallest and the largest height of the points within the domain.
  double lowest_found() const { return curve_.lowest().y; }
  double highest_found() const { return curve_.highest().y; }

  /// Of beta(a,a).
  double symmetric_height() const { return curve_.points().front().y; }

  /// Where the curve ends: the smaller fraction of split(x), and its height.
  double end_fraction() const { return end_fraction_; }
  double end_height() const { return end_height_; }

 private:
  double depth_;
  double symmetric_;  ///< a = b of this depth
  ScannedCurve curve_;
  double end_fraction_, end_height_;
};

}  // namespace ramify
