#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim F_n / log n, F_n the fill level.
///
/// bst and beta trees of both kinds: max over t < 0 of (-t)/log M(t), M as for the height (log_moment.hpp);
/// bst 0.373364617701674, the smaller root of c log(2e/c) = 1 (C18). split and patricia: 1/log(1/min(p,1-p))
/// (C16, corollary B.2; C17). Nothing for dst, for which no source states it, nor for catalan, whose fill
/// level stays bounded. aldous(beta): that of beta(beta+1,beta+1) for beta > -1, else nothing. complete:
/// 1/log 2.
std::optional<Constant> fill_level_constant(const Model& model);

}  // namespace ramify
