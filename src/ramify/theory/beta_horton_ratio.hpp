#pragma once

#include <optional>

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// R(a,b), the limiting Horton ratio of random trees with split density proportional to x^(a-1) (1-x)^(b-1):
/// streams of order k over streams of order k+1, and S_n ~ log n / log R.
///
/// For a, b > 0 beta(a,b); for -1 < a, b <= 0 too, as the limit of splits cut off at 1/n: a = b = beta+1 is
/// Aldous' beta-splitting tree, a = b = -1/2 the uniform (Catalan) tree. R(a,b) = R(b,a); R(a,a+1) = R(a,a).
///
/// @param split  a, b > -1
/// @return value and estimated error: the change from the last mesh but one, and a floor of 1e-12 for
/// rounding. 8 digits and more for a+b <= 200 and means in 0.05..0.95; nothing where no wave was found (a+b
/// beyond about 10^4) Cost: 0.01 to 1 s. The equation: horton_wave.hpp, docs/theory/horton-ratio.md.
std::optional<Rounded> beta_horton_ratio(const BetaSplit& split);

}  // namespace ramify
