#pragma once

#include <cmath>

#include "ramify/compare/interval.hpp"

namespace ramify {

/// A number as a source prints it: known to half a unit of its last digit.
struct Printed {
  double value;
  double half_unit = 0.005;

  Interval interval() const { return {value - half_unit, value + half_unit}; }
};

/// The human lung: K96 Table 5.1 after Cumming et al. 1970, the rows of data/lung.csv (tests/unit/claim_test
/// holds them against it).
struct LungTree {
  Printed bifurcation, diameter;  ///< ratios from order to order
  Printed largest_cm;             ///< mean diameter of order 17
};
inline constexpr LungTree bronchial_tree{{2.74}, {1.40}, {1.61}};
inline constexpr LungTree pulmonary_artery{{3.39}, {1.71}, {1.86}};
inline constexpr int lung_orders = 17;

}  // namespace ramify
