#pragma once

#include <span>

#include "ramify/fit/model_fits.hpp"
#include "ramify/io/table.hpp"
#include "ramify/report/plot.hpp"

namespace ramify {

/// Pairs of shapes along the valleys of all fits that have one, by ascending a+b:
/// data,model,a,b,horton_ratio, log_likelihood,below_best,place (docs/fitting-models.md).
Table valley_table(std::span<const FittedDatum> data);

/// The same as a picture: b against a, one curve a fit, the estimates as points.
Plot valley_plot(std::span<const FittedDatum> data);

}  // namespace ramify
