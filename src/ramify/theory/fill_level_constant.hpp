#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim F_n / log n, F_n the fill level.
///
/// X ~ beta(a,b): max over t < 0 of (-t)/log M(t), M as for the height (log_moment.hpp); of a uniform X
/// 0.373364617701674, the smaller root of c log(2e/c) = 1 (C18). X constant: 1/log(1/min(p,1-p)) (C16,
/// corollary B.2; C17); nothing where sizes scatter by Scatter::binomial, for which no source states it.
/// Perfect subtrees: 1/log 2. Nothing where there is no X: the fill level of a uniform tree stays bounded.
std::optional<Constant> fill_level_constant(const Model& model);

}  // namespace ramify
