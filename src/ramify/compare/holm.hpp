#pragma once

#include <vector>

namespace ramify {

/// p-values adjusted for there being several (Holm 1979): the chance that any of them is wrongly called small
/// stays below the level, whatever their dependence. The i-th smallest of m is multiplied by m - i + 1, no
/// less than those before it, at most 1.
std::vector<double> holm_adjusted(const std::vector<double>& p_values);

}  // namespace ramify
