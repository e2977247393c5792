#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ramify/family/log_rising.hpp"
#include "ramify/family/observed_splits.hpp"

namespace ramify {

/// Minus the log-likelihood of splits under Aldous's beta-splitting.
///
/// Of m leaves k go left with probability f(k) f(m-k) / Z(m), and both written without common factors
///   f(k) = (1 + beta/2) (1 + beta/3) ... (1 + beta/k),
///   Z(m) = sum of f(k) f(m-k) over k = 1..m-1 = [(2c)_m - 2 (c)_m] / (m! c^2),   c = beta+1,
/// in rising factorials (Vandermonde). With U_x = (1 + x/2) ... (1 + x/(m-1)) that is
///   Z(m) = 2/m U_2c [1 + (1+c) (1 - U_c / U_2c) / c],
/// in which nothing cancels: at c = 0 the last factor is a harmonic sum. So the likelihood depends on how
/// many subtrees there are of each size, and on nothing else.
class AldousLikelihood {
 public:
  explicit AldousLikelihood(const ObservedSplits& observed);

  /// O(number of sizes). @param beta  above -2
  template <class T>
  T operator()(const T& beta) const {
    using std::log1p;
    const T c = beta + 1.0;
    const LogRising<T> weight(beta, 2), once(c, 2), twice(2.0 * c, 2);
    T minus_log(constant_);
    for (const OfSize& of : sizes_) {
      if (of.as_child != 0) minus_log -= of.as_child * weight(of.size + 1);
      if (of.as_node == 0) continue;
      const T all = twice(of.size);
      minus_log += of.as_node * (all + log1p((beta + 2.0) * lost_share(c, all - once(of.size), of)));
    }
    return minus_log;
  }

 private:
  static constexpr double near_0 = 1e-3;

  struct OfSize {
    Size size;  ///< internal nodes
    double as_child, as_node;
    std::array<double, 4> harmonic;  ///< sums of 1/t, 1/t^2, .. over t = 2..size
  };

  /// (1 - e^-log_ratio) / c, where log_ratio = log(U_2c / U_c) = sum of log((t + 2c) / (t + c)).
  template <class T>
  static T lost_share(const T& c, const T& log_ratio, const OfSize& of) {
    using std::expm1;
    if (c >= near_0 || c <= -near_0) return -expm1(-log_ratio) / c;
    const auto& h = of.harmonic;
    const T slope = h[0] - c * (3.0 / 2 * h[1] - c * (7.0 / 3 * h[2] - c * (15.0 / 4 * h[3])));
    const T x = -c * slope;  // small: below 0.05 at all sizes there are
    return slope * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0)))));
  }

  double constant_ = 0;
  std::vector<OfSize> sizes_;
};

}  // namespace ramify
