#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim B_n / log n, B_n the balance number.
///
/// X ~ beta(a,b): min over t > 1 of t/theta(t) (beta_balance.hpp); of a uniform X 1.0262..., which
/// refutes theorem C.2 of Kruszewski 1996 (C19). X constant: 1/log(1/min(p,1-p)), what the minimum falls to
/// as t grows (corollary B.2; C17); nothing where sizes scatter by Scatter::binomial, for which no source
/// states it. Perfect subtrees: 1/log 2. Nothing where there is no X.
std::optional<Constant> balance_constant(const Model& model);

}  // namespace ramify
