#pragma once

#include <span>
#include <vector>

namespace ramify {

/// What is left of the weights without the ends below `negligible`, scaled in place to sum 1; at least one
/// must be kept. O(length).
std::span<double> trim_to_law(std::vector<double>& weights, double negligible);

}  // namespace ramify
