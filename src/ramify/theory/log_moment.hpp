#pragma once

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// log M(t), M(t) = E[X^t + (1-X)^t], X ~ beta(a,b), t > -min(a,b):
///   M(t) = Gamma(a+b)/Gamma(a+b+t) [Gamma(a+t)/Gamma(a) + Gamma(b+t)/Gamma(b)].
/// log M is convex; M(0) = 2, M(1) = 1. Height and fill level both lie where a tangent of log M passes
/// through the origin.
/// @tparam Real  Precise, or double to know about where: log-gammas of large a and b cancel
template <class Real>
class LogMomentOf {
 public:
  explicit LogMomentOf(const BetaSplit& split);

  /// Whether 50 digits reach from log Gamma(a+b) to log M: a and b within 1e-25..1e25.
  static bool reaches(const BetaSplit& split);

  Real operator()(const Real& t) const { return value(log_terms(t)); }

  /// The root of t (log M)'(t) = log M(t) between two points that bracket it.
  ///
  /// Both constants are stationary there: half the working digits of t give all of them in the value.
  Real tangent_point(const Real& low, const Real& high) const;

  /// t (log M)'(t) - log M(t).
  Real tangent_gap(const Real& t) const;

  /// The largest log-gamma in log M(t), over |log M(t)|: what cancels there.
  Real cancelled(const Real& t) const;

 private:
  struct LogTerms {
    Real left;   ///< log E X^t
    Real right;  ///< log E (1-X)^t
  };
  LogTerms log_terms(const Real& t) const;
  static Real value(const LogTerms& terms);
  Real derivative(const Real& t, const LogTerms& terms) const;

  Real a_, b_;
  Real normaliser_a_, normaliser_b_;  ///< log of Gamma(a+b)/Gamma(a) and of Gamma(a+b)/Gamma(b)
};

extern template class LogMomentOf<Precise>;
extern template class LogMomentOf<double>;

using LogMoment = LogMomentOf<Precise>;

}  // namespace ramify
