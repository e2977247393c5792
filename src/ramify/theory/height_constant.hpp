#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/binary_split.hpp"
#include "ramify/theory/constant.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// lim H_n / log n = min over t > 1 of t / (-log M(t)), M(t) = E[X^t + (1-X)^t], X the limiting split
/// fraction.
///
/// X ~ beta(a,b): M(t) = Gamma(a+b)/Gamma(a+b+t) [Gamma(a+t)/Gamma(a) + Gamma(b+t)/Gamma(b)]; of a uniform X
/// M = 2/(t+1), 4.311070407001. X constant: 1/log(1/max(p,1-p)), the limit of the minimum as t grows. Perfect
/// subtrees: 1/log 2. Nothing where there is no X: heights grow like powers of n or of log n. H_n/log n
/// itself is 20-25 % lower at n = 10^4. Devroye 1986, Reed 2003, Pittel 1985 (C7).
std::optional<Constant> height_constant(const Model& model);

/// The number alone, of X ~ beta(a,b), a, b > 0: the nearest double; nothing where 50 digits do not reach.
/// Cost: some 5 ms.
std::optional<Rounded> beta_height(const BetaSplit& split);

/// The same of a constant X.
std::optional<Rounded> fixed_height(const BinarySplit& split);

}  // namespace ramify
