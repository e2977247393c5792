#pragma once

#include <functional>
#include <span>

namespace ramify {

/// Minus the log-likelihood of observed splits, of the numbers that a family searches (SearchScale), with its
/// gradient where that is not null: the product over all nodes of
///   q(i) + q(j) where the children have i and j != i internal nodes, q(i) where both have i,
/// q the family's split law. False where it is not finite.
using SplitLikelihood =
    std::function<bool(std::span<const double> searched, double& value, double* gradient)>;

}  // namespace ramify
