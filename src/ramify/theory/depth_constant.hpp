#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim E D_n / log n = 1/mu, mu = E[X log(1/X) + (1-X) log(1/(1-X))], X the limiting split fraction.
///
/// beta(a,b), beta_multinomial(a,b): mu = psi(a+b+1) - (a psi(a+1) + b psi(b+1))/(a+b); bst: 2. split(x),
/// dst(p), patricia(p): mu is the entropy of p. aldous(beta): that of beta(beta+1,beta+1) for
/// beta > -1. complete: 1/log 2. Nothing for catalan, whose depth grows like sqrt(n), nor for aldous and
/// chain beyond. Devroye 1998; Aldous 1996; theorem 2.1 of Kruszewski 1996 (C6).
std::optional<Constant> depth_constant(const Model& model);

}  // namespace ramify
