#include "ramify/theory/log_moment.hpp"

#include <algorithm>
#include <cstdint>

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/toms748_solve.hpp>

namespace ramify {

using boost::math::digamma;

LogMoment::LogMoment(const BetaSplit& split) : a_(split.a), b_(split.b) {
  const Precise both = lgamma(a_ + b_);
  normaliser_a_ = both - lgamma(a_);
  normaliser_b_ = both - lgamma(b_);
}

bool LogMoment::reaches(const BetaSplit& split) {
  constexpr double widest = 1e25;
  return std::max(split.a, split.b) <= widest && std::min(split.a, split.b) >= 1 / widest;
}

Precise LogMoment::operator()(const Precise& t) const {
  const LogTerms terms = log_terms(t);
  const Precise top = std::max(terms.left, terms.right);
  return top + log1p(exp(std::min(terms.left, terms.right) - top));
}

Precise LogMoment::derivative(const Precise& t) const {
  const LogTerms terms = log_terms(t);
  const Precise share = 1 / (1 + exp(terms.right - terms.left));  // of E X^t in M(t)
  return share * digamma(a_ + t) + (1 - share) * digamma(b_ + t) - digamma(a_ + b_ + t);
}

Precise LogMoment::tangent_point(const Precise& low, const Precise& high) const {
  std::uintmax_t iterations = 200;
  const boost::math::tools::eps_tolerance<Precise> half_the_digits(std::numeric_limits<Precise>::digits / 2);
  const auto gap = [this](const Precise& t) -> Precise { return tangent_gap(t); };
  const auto bracket = boost::math::tools::toms748_solve(gap, low, high, half_the_digits, iterations);
  return (bracket.first + bracket.second) / 2;
}

Precise LogMoment::cancelled(const Precise& t) const {
  return (1 + abs(lgamma(a_ + b_ + t)) + abs(normaliser_a_) + abs(normaliser_b_)) / abs((*this)(t));
}

LogMoment::LogTerms LogMoment::log_terms(const Precise& t) const {
  const Precise both = lgamma(a_ + b_ + t);
  return {normaliser_a_ + lgamma(a_ + t) - both, normaliser_b_ + lgamma(b_ + t) - both};
}

}  // namespace ramify
