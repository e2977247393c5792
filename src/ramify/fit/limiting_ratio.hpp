#pragma once

#include <optional>

#include "ramify/fit/family_fit.hpp"

namespace ramify {

/// R(a,b), the limiting Horton ratio (theory/horton_ratio_constant.hpp) of a fitted law with a split density:
/// what counts of streams tell of two shapes, which by themselves they hardly tell. Likewise that of Tokunaga
/// numbers (theory/tokunaga_horton_ratio.hpp).
///
/// Of one parameter its interval's ends are mapped; of two log R is taken to be linear about the estimate
/// (the delta method). Nothing where the family has neither, the estimate lies at the end of what is
/// searched, or R is out of reach. Cost: some
/// evaluations of R, 0.01 to 1 s each.
std::optional<FittedParameter> limiting_ratio(const FamilyFit& fit);

}  // namespace ramify
