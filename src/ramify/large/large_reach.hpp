#pragma once

#include <string>

#include "ramify/law/law_cost.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// Nothing where a model's laws go beyond the exact ones; else why they end: "its splits are known at whole
/// sizes alone".
std::string no_large_laws(const Model& model);

/// The size from which on a model's binomial splits scatter so widely that their rows are smooth; 0 where
/// they are not binomial. O(1).
double smooth_from(const Model& model);

/// The sizes 0..n that are computed exactly before the grid begins: 2048; more where a binomial split is
/// lopsided. The law at half of it is computed too.
Size large_law_table(const Model& model);

/// Seconds that a law to n takes on the grid, on one core, right to a factor of 3: what grows with n is
/// heights and depths of models in which they grow like a power of n. O(1).
double large_law_seconds(const Model& model, const Recurrence& recurrence, double n);

}  // namespace ramify
