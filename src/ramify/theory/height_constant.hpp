#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim H_n / log n = min over t > 1 of t / (-log M(t)), M(t) = E[X^t + (1-X)^t], X the limiting split
/// fraction.
///
/// beta(a,b), beta_multinomial(a,b): M(t) = Gamma(a+b)/Gamma(a+b+t) [Gamma(a+t)/Gamma(a) +
/// Gamma(b+t)/Gamma(b)]; bst: M = 2/(t+1), 4.311070407001. split(x), dst(p), patricia(p):
/// 1/log(1/max(p,1-p)), the limit of the minimum as t grows. aldous(beta): that of
/// beta(beta+1,beta+1) for beta > -1. complete: 1/log 2. Nothing for catalan, whose height grows like
/// sqrt(n), nor for aldous and chain beyond. H_n/log n itself is 20-25 % lower at n = 10^4. Devroye 1986,
/// Reed 2003, Pittel 1985 (C7).
std::optional<Constant> height_constant(const Model& model);

}  // namespace ramify
