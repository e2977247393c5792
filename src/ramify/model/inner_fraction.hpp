#pragma once

#include <cmath>

#include "ramify/core/contract.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/random/variates.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// X in (0,1) with density proportional to x^(a-1) (1-x)^a (1 - (1-x)^n), -1 < a < 1, n >= 2: a beta(a,a+1)
/// fraction, given that of n trials with it one at least succeeds.
///
/// The last factor is what makes it a density for a <= 0. Rejection from three pieces, joined at 1/n and 1/2,
/// whose integrals are in closed form: x^(a-1) or (1-x)^a, whichever has its singularity there, times a bound
/// of the rest. Below 1/n that is nx: (1-x)^a (1 - (1-x)^n) <= nx even for a = -1, by Bonferroni's inequality
/// from n = 4 on, and 1.5 nx for n = 2, 3. Of all tries 0.6 and more
/// succeed from n = 4 on, 0.4 at n = 2 and 3 (tests/statistical).
class InnerFraction {
 public:
  InnerFraction(double a, Size n)
      : a_(a),
        n_(static_cast<double>(n)),
        log_ratio_(std::log(n_ / 2)),
        growth_(std::expm1(a * log_ratio_)),
        low_bound_(a < 0 && n < 4 ? 1.5 : 1),
        middle_bound_(a < 0 ? std::exp2(-a) : 1) {
    RAMIFY_EXPECTS(a > -1 && a < 1 && n >= 2);
  }

  template <class Urbg>
  UnitPair operator()(Urbg& stream) const {
    // Integrals of the bounds, times n^-a.
    const double low = low_bound_ / (a_ + 1);
    const double middle = middle_bound_ * (a_ == 0 ? log_ratio_ : growth_ / a_);
    const double high = std::exp2(-a_) * (1 + growth_) / (a_ + 1);
    for (;;) {
      const double piece = uniform_open(stream) * (low + middle + high);
      const double level = uniform_open(stream), test = uniform_open(stream);
      if (piece >= low + middle) {
        const double y = end(level) / 2;
        if (test < -std::expm1(n_ * std::log(y)) * std::pow(2 * (1 - y), a_ - 1)) return {1 - y, y};
        continue;
      }
      const bool is_low = piece < low;
      const double x = is_low ? end(level) / n_ : between(level) / n_;
      const double bound = is_low ? low_bound_ * n_ * x : middle_bound_;
      const double log_rest = std::log1p(-x);
      if (x == 0 || test * bound < -std::expm1(n_ * log_rest) * std::exp(a_ * log_rest)) return {x, 1 - x};
    }
  }

 private:
  /// In (0,1) with density proportional to x^a; 0 where it underflows.
  double end(double level) const { return std::pow(level, 1 / (a_ + 1)); }

  /// In (1, n/2) with density proportional to x^(a-1).
  double between(double level) const {
    return std::exp(a_ == 0 ? level * log_ratio_ : std::log1p(level * growth_) / a_);
  }

  double a_;
  double n_;
  double log_ratio_;  // log(n/2)
  double growth_;     // (n/2)^a - 1
  double low_bound_;
  double middle_bound_;
};

}  // namespace ramify
