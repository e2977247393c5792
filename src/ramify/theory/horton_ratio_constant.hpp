#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// R, the limiting Horton ratio: the limit as n grows of E M_k / E M_(k+1), M_k the streams of order k, and
/// then as k grows.
///
/// X ~ beta(a,b), and its density cut off at 1/n where a or b is in (-1,0]: R(a,b) of beta_horton_ratio.hpp,
/// nothing where no wave was found; of a uniform X bst_horton_ratio.hpp, 3.04382786183867; of a = b = -1/2,
/// the uniform tree, 4 (Moon 1980). Perfect subtrees: 2. X constant: 1/min(p,1-p) (C10, C11, C17), reached
/// slowly in k; where log p / log(1-p) is rational, as for p = 1/2, the ratios of a fixed order oscillate
/// with log n; nothing where sizes scatter by Scatter::binomial, for which no source states it. The ratios of
/// nodes have the same limit, but not where a or b is negative (of the uniform tree 2).
std::optional<Constant> horton_ratio_constant(const Model& model);

}  // namespace ramify
