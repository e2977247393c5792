#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/constant.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// lim E D_n / log n = 1/mu, mu = E[X log(1/X) + (1-X) log(1/(1-X))], X the limiting split fraction.
///
/// X ~ beta(a,b): mu = psi(a+b+1) - (a psi(a+1) + b psi(b+1))/(a+b); of a uniform X the limit is 2. X
/// constant, p: mu is its entropy. Perfect subtrees: 1/log 2. Nothing where there is no X: depths grow like
/// powers of n or of log n. Devroye 1998; Aldous 1996; theorem 2.1 of Kruszewski 1996 (C6).
std::optional<Constant> depth_constant(const Model& model);

/// The number alone, of X ~ beta(a,b), a, b > 0: the nearest double; nothing where 50 digits do not reach.
std::optional<Rounded> beta_depth(const BetaSplit& split);

/// The same of a constant X.
std::optional<Rounded> fixed_depth(const BinarySplit& split);

}  // namespace ramify
