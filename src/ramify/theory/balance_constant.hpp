#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim B_n / log n, B_n the balance number.
///
/// bst and beta trees of both kinds: min over t > 1 of t/theta(t) (beta_balance.hpp); bst 1.0262..., which
/// refutes theorem C.2 of Kruszewski 1996 (C19). split and patricia: 1/log(1/min(p,1-p)), what the minimum
/// falls to as t grows where X is constant (corollary B.2; C17). Nothing for dst, for which no source states
/// it, nor for catalan. aldous(beta): that of beta(beta+1,beta+1) for beta > -1, else nothing. complete:
/// 1/log 2.
std::optional<Constant> balance_constant(const Model& model);

}  // namespace ramify
