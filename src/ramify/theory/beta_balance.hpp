#pragma once

#include <optional>

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// lim B_n / log n, B_n the balance number of trees with split fraction X ~ beta(a,b): min over t > 1 of
/// t/theta(t),
///   e^theta E[min(X,1-X)^t] + E[max(X,1-X)^t] = 1.
///
/// @param split  a, b > 0. Nothing beyond 1e-20..1e5, where the incomplete betas lose their digits or take
/// seconds. Cost: 0.02 s; 0.3 s for a + b = 2000. Markov's inequality gives the upper bound, the branching
/// random walk (Biggins 1978) says that it is attained; docs/theory/balance.md.
std::optional<Rounded> beta_balance(const BetaSplit& split);

/// The same for random binary search trees, e^theta = 1 + (t-1) 2^t: 1.0262..., and not the 1/log 3 of
/// Kruszewski 1996, theorem C.2 (C19).
Rounded bst_balance();

}  // namespace ramify
