#pragma once

#include <string>

#include "ramify/io/table.hpp"
#include "ramify/model/model.hpp"
#include "ramify/theory/beta_split.hpp"

namespace ramify {

/// 12 significant digits of a parameter that was solved for: enough for constants to 1e-11, and 1 is 1.
double to_design_digits(double parameter);

/// "beta(10,80)"
std::string beta_text(const BetaSplit& split);

/// The depth and height constant of a model (theory/); NaN where one is not known.
double depth_of(const Model& model);
double height_of(const Model& model);

/// model, a, b, depth, height: the constants of the printed a and b.
Row beta_row(const BetaSplit& split);

}  // namespace ramify
