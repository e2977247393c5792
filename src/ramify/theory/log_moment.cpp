#include "ramify/theory/log_moment.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace ramify {
namespace {

using boost::math::digamma;

double log_gamma(double x) {
  return boost::math::lgamma(x);
}

Precise log_gamma(const Precise& x) {
  return lgamma(x);
}

}  // namespace

template <class Real>
LogMomentOf<Real>::LogMomentOf(const BetaSplit& split) : a_(split.a), b_(split.b) {
  const Real both = log_gamma(a_ + b_);
  normaliser_a_ = both - log_gamma(a_);
  normaliser_b_ = both - log_gamma(b_);
}

template <class Real>
bool LogMomentOf<Real>::reaches(const BetaSplit& split) {
  constexpr double widest = 1e25;
  return std::max(split.a, split.b) <= widest && std::min(split.a, split.b) >= 1 / widest;
}

template <class Real>
Real LogMomentOf<Real>::value(const LogTerms& terms) {
  using std::exp, std::log1p;
  const Real top = std::max(terms.left, terms.right);
  return top + log1p(exp(std::min(terms.left, terms.right) - top));
}

template <class Real>
Real LogMomentOf<Real>::derivative(const Real& t, const LogTerms& terms) const {
  using std::exp;
  const Real share = 1 / (1 + exp(terms.right - terms.left));  // of E X^t in M(t)
  return share * digamma(a_ + t) + (1 - share) * digamma(b_ + t) - digamma(a_ + b_ + t);
}

template <class Real>
Real LogMomentOf<Real>::tangent_gap(const Real& t) const {
  const LogTerms terms = log_terms(t);
  return t * derivative(t, terms) - value(terms);
}

template <class Real>
Real LogMomentOf<Real>::tangent_point(const Real& low, const Real& high) const {
  std::uintmax_t iterations = 200;
  const boost::math::tools::eps_tolerance<Real> half_the_digits(std::numeric_limits<Real>::digits / 2);
  const auto gap = [this](const Real& t) -> Real { return tangent_gap(t); };
  const auto bracket = boost::math::tools::toms748_solve(gap, low, high, half_the_digits, iterations);
  return (bracket.first + bracket.second) / 2;
}

template <class Real>
Real LogMomentOf<Real>::cancelled(const Real& t) const {
  using std::abs;
  return (1 + abs(log_gamma(a_ + b_ + t)) + abs(normaliser_a_) + abs(normaliser_b_)) / abs((*this)(t));
}

template <class Real>
typename LogMomentOf<Real>::LogTerms LogMomentOf<Real>::log_terms(const Real& t) const {
  const Real both = log_gamma(a_ + b_ + t);
  return {normaliser_a_ + log_gamma(a_ + t) - both, normaliser_b_ + log_gamma(b_ + t) - both};
}

template class LogMomentOf<Precise>;
template class LogMomentOf<double>;

}  // namespace ramify
