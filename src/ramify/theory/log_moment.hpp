#pragma once

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// log M(t), M(t) = E[X^t + (1-X)^t], X ~ beta(a,b), t > -min(a,b):
///   M(t) = Gamma(a+b)/Gamma(a+b+t) [Gamma(a+t)/Gamma(a) + Gamma(b+t)/Gamma(b)].
/// log M is convex; M(0) = 2, M(1) = 1. Height and fill level both lie where a tangent of log M passes
/// through the origin.
class LogMoment {
 public:
  explicit LogMoment(const BetaSplit& split);

  /// Whether 50 digits reach from log Gamma(a+b) to log M: a and b within 1e-25..1e25.
  static bool reaches(const BetaSplit& split);

  Precise operator()(const Precise& t) const;
  Precise derivative(const Precise& t) const;

  /// The root of t (log M)'(t) = log M(t) between two points that bracket it.
  ///
  /// Both constants are stationary there: half the working digits of t give all of them in the value.
  Precise tangent_point(const Precise& low, const Precise& high) const;

  /// t (log M)'(t) - log M(t).
  Precise tangent_gap(const Precise& t) const { return t * derivative(t) - (*this)(t); }

  /// The largest log-gamma in log M(t), over |log M(t)|: what cancels there.
  Precise cancelled(const Precise& t) const;

 private:
  struct LogTerms {
    Precise left;   ///< log E X^t
    Precise right;  ///< log E (1-X)^t
  };
  LogTerms log_terms(const Precise& t) const;

  Precise a_, b_;
  Precise normaliser_a_, normaliser_b_;  ///< log of Gamma(a+b)/Gamma(a) and of Gamma(a+b)/Gamma(b)
};

}  // namespace ramify
