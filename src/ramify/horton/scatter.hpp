#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ramify/horton/ratio_kind.hpp"

namespace ramify {

/// The standard error of log R where no model says one: the values are taken to lie about a straight line
/// log x_k = a + k log R, each off it independently by the same variance, that of the residuals (m-1 degrees
/// of freedom for m+1 values). NaN for fewer than three known values. By the delta method for what is no
/// regression.
double scatter_error(RatioKind kind, std::span<const double> rising);

/// Places of values that lie off the line of the others: the residual in units of its standard error from the
/// regression without the value (externally studentised; Weisberg 2005, 9.1) is beyond Student's t
/// quantile for 5 % over all values together (Bonferroni). None for fewer than five known values.
std::vector<std::size_t> off_the_line(std::span<const double> values);

}  // namespace ramify
