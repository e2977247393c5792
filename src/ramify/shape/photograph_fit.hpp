#pragma once

#include <span>

namespace ramify {

/// Three lengths of a tree on a photograph, in any unit (H8; Aono and Kunii 1984, Figure 18).
struct Silhouette {
  double base;     ///< H_0, from the foot to the first branching
  double height;   ///< H, of the whole tree
  double lateral;  ///< L, from the first branching to the farthest tip at the side
};

/// By what a main branch and a lateral one are shorter than their mother.
struct Contraction {
  double main, secondary;
};

/// GMT1 and GMT3 as the source fits them: R1 = 1 - H_0/H, R2 = R1 L/(H - H_0). The first neglects R1^n (X47):
/// at 7 levels of a ginkgo 0.826 for 0.903.
Contraction approximate_contraction(const Silhouette& tree);

/// The same without the neglect: H = H_0 (1 + R1 + ... + R1^n), solved for R1; L/(H - H_0) = R2/R1 holds for
/// every n. @param levels  n, at least 1
///
/// Both throw Error unless 0 < H_0 < H and L >= 0.
Contraction exact_contraction(const Silhouette& tree, unsigned levels);

/// The ratio by which branches shorten from level to level, with a two-sided 80 % interval, as the source
/// prints them: the gradient of log length against level by least squares (H10; Figure 16).
struct ContractionEstimate {
  double ratio, low, high;
};

/// @param levels   of the branches, one for each length; not all the same
/// @param lengths  above 0; three at least
/// Throws Error for anything else.
ContractionEstimate contraction_by_level(std::span<const double> levels, std::span<const double> lengths);

/// A row of the source's table 2b: mean branching angles of a tree in degrees.
struct AnglesByHeight {
  double average, bottom, top;
};

/// Angles of GMT4 that go best with a row, given its category (H12): the rule `levels` of deviation_rules().
struct LevelAngles {
  double highest, lowest;  ///< of the rule
  double residual;         ///< root of the mean square of average, bottom and top less those of the rule
};

/// By least squares. @param category  1 to 5
LevelAngles fit_level_angles(const AnglesByHeight& angles, int category);

}  // namespace ramify
