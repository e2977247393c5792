#pragma once

#include <cmath>

namespace ramify {

/// The limiting Horton ratio of trees with T_k = a c^(k-1) side branches k orders below, as the order grows:
/// the larger root of R^2 - (2 + a + c) R + 2 c = 0. a, c > 0. Tokunaga 1978; Peckham 1995.
///
/// @tparam T  double, or a number that carries its derivatives
template <class T>
T tokunaga_horton_ratio(const T& a, const T& c) {
  using std::sqrt;
  const T half = (2.0 + a + c) / 2.0;
  return half + sqrt(half * half - 2.0 * c);
}

}  // namespace ramify
