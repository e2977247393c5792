#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// log of (1 + c/first) (1 + c/(first+1)) ... (1 + c/k): of first = 1 the rising factorial (c+1)_k over k!.
///
/// Summed up to 64, from there on the difference of two log-gammas in Stirling's form. c > -first and at most
/// some 10^3; absolute error about 1e-15 (1 + |c| log k). 64 logarithms to make, two a value.
/// @tparam T  double, or a number that carries its derivatives
template <class T>
class LogRising {
 public:
  explicit LogRising(const T& c, std::size_t first = 1) : c_(c) {
    using std::log1p;
    sums_.fill(T(0.0));
    for (std::size_t t = first; t < summed; ++t) sums_[t] = sums_[t - 1] + log1p(c / static_cast<double>(t));
    start_ = sums_.back() - excess(static_cast<double>(summed));
  }

  /// 0 where k < first.
  T operator()(Size k) const { return k < summed ? sums_[k] : start_ + excess(static_cast<double>(k) + 1); }

 private:
  static constexpr std::size_t summed = 65;

  /// log Gamma(z) less Stirling's (z - 1/2) log z - z + log(2 pi)/2; the next term is below 1e-19 at 62.
  template <class U>
  static U stirling_rest(const U& z) {
    const U square = 1.0 / (z * z);
    return (1.0 / 12 - square * (1.0 / 360 - square * (1.0 / 1260 - square / 1680.0))) / z;
  }

  /// log(Gamma(x+c) / Gamma(x)).
  T excess(double x) const {
    using std::log1p;
    return c_ * std::log(x) + (c_ + (x - 0.5)) * log1p(c_ / x) - c_ + stirling_rest(T(c_ + x)) -
           stirling_rest(x);
  }

  T c_;
  std::array<T, summed> sums_;
  T start_;
};

}  // namespace ramify
