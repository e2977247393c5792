#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// R, the limiting Horton ratio: the limit as n grows of E M_k / E M_(k+1), M_k the streams of order k, and
/// then as k grows.
///
/// bst: bst_horton_ratio.hpp, 3.04382786183867. beta trees of both kinds: beta_horton_ratio.hpp,
/// nothing where no wave was found; aldous(beta): R(beta+1,beta+1). complete: 2.
/// catalan: 4 (Moon 1980; ratios of nodes tend to 2). split and patricia: 1/min(p,1-p) (C10, C11, C17),
/// reached slowly in k; where log p / log(1-p) is rational, as for p = 1/2, the ratios of a fixed order
/// oscillate with log n. For all but catalan and aldous(beta), beta < -1, the ratios of nodes have
/// the same limit. Nothing for dst, for
/// which no source states it.
std::optional<Constant> horton_ratio_constant(const Model& model);

}  // namespace ramify
