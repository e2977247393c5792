#pragma once

#include <string>
#include <vector>

#include "ramify/measure/tree_measurement.hpp"

namespace ramify {

/// Everything that is known of the trees as a JSON list, an object a tree: counts of orders, all four ratio
/// estimators of nodes and streams, the statistics of the registry, the ramification matrix, Tokunaga
/// numbers, and where there is geometry the ratios of Horton's second law and Murray's exponent. Numbers have
/// at most 10 significant digits; null stands for none.
/// @param leaf_order  0 or 1; lists by orders begin with it
std::string measurement_json(const std::vector<TreeMeasurement>& trees, unsigned leaf_order);

}  // namespace ramify
