#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "claim.hpp"

namespace ramify {

/// The elements of one order: how many, and their mean diameter and length in mm.
struct VesselOrder {
  int order;
  double count, diameter, length;
};

inline constexpr double unknown_diameter = std::numeric_limits<double>::quiet_NaN();

/// The arteries and the veins of the human lung: Huang, Yen, McLaurine and Bledsoe 1996, the rows of
/// data/pulmonary_artery.csv and data/pulmonary_vein.csv (tests/unit/claim_test holds them against these).
/// Orders are those of diameters; order 1 is the smallest.
inline constexpr std::array measured_artery{
    VesselOrder{1, 51205812, 0.02, 0.22}, VesselOrder{2, 14057197, 0.036, 0.26},
    VesselOrder{3, 5101903, 0.056, 0.36}, VesselOrder{4, 2256846, 0.097, 0.45},
    VesselOrder{5, 674169, 0.15, 0.68},   VesselOrder{6, 285772, 0.22, 1.08},
    VesselOrder{7, 86020, 0.34, 1.92},    VesselOrder{8, 22004, 0.51, 2.81},
    VesselOrder{9, 6225, 0.77, 3.73},     VesselOrder{10, 1724, unknown_diameter, 6.58},
    VesselOrder{11, 450, 1.75, 12.35},    VesselOrder{12, 127, 2.71, 18.07},
    VesselOrder{13, 43, 4.16, 25.97},     VesselOrder{14, 7, 7.34, 35.7},
    VesselOrder{15, 2, 14.8, 25.3}};
inline constexpr std::array measured_vein{
    VesselOrder{1, 39823553, 0.018, 0.13}, VesselOrder{2, 8494245, 0.031, 0.21},
    VesselOrder{3, 2166333, 0.067, 0.38},  VesselOrder{4, 453051, 0.13, 1.06},
    VesselOrder{5, 73025, 0.23, 1.5},      VesselOrder{6, 15567, 0.38, 2.92},
    VesselOrder{7, 3721, 0.62, 4.79},      VesselOrder{8, 1067, 0.9, 6.78},
    VesselOrder{9, 435, 1.42, 11.24},      VesselOrder{10, 143, 1.99, 14.78},
    VesselOrder{11, 63, 2.88, 17.9},       VesselOrder{12, 31, 4, 26.49},
    VesselOrder{13, 11, 5.86, 19.49},      VesselOrder{14, 4, 8.65, 34.99},
    VesselOrder{15, 2, 12.97, 35.68}};

/// A coefficient of a least-squares fit, and what Student's t makes of its scatter.
struct FittedCoefficient {
  double value, standard_error, degrees;

  /// That holds the true value with probability 1 - chance, where residuals are normal and alike.
  Interval interval(double chance) const;
};

/// Of x^power in the polynomial of that degree that fits y best. @param power  0, 1, ...; more points than
/// power + 1
FittedCoefficient leading_coefficient(std::span<const double> x, std::span<const double> y, int power);

/// Parts C35.<first>, ...: Horton's second law and Murray's exponent of these vessels.
std::vector<ClaimPart> measured_second_law_parts(std::size_t first);

}  // namespace ramify
