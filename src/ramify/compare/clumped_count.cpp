#include "ramify/compare/clumped_count.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

/// Polya-Aeppli probabilities, one after the other.
class ClumpLaw {
 public:
  ClumpLaw(double mean, double variance)
      : stay_(variance > mean ? (variance - mean) / (variance + mean) : 0),
        clumps_(mean * (1 - stay_)),
        now_(std::exp(-clumps_)) {}

  double x() const { return x_; }
  double probability() const { return now_; }

  void step() {
    const double next =
        ((clumps_ * (1 - stay_) + 2 * stay_ * x_) * now_ - stay_ * stay_ * std::max(0.0, x_ - 1) * before_) /
        (x_ + 1);
    before_ = now_;
    now_ = next;
    ++x_;
  }

 private:
  double stay_;    ///< a clump goes on
  double clumps_;  ///< expected
  double x_ = 0, before_ = 0, now_;
};

double tail_up_to(double total, ClumpLaw law) {
  double sum = 0;
  for (; law.x() <= total; law.step()) sum += law.probability();
  return sum;
}

double tail_from(double total, double mean, ClumpLaw law) {
  constexpr double negligible = 1e-12;
  double sum = 0;
  while (law.x() < total) law.step();
  for (; law.x() < mean || law.probability() > negligible * sum; law.step()) sum += law.probability();
  return sum;
}

}  // namespace

double clumped_count_z(double total, double mean, double variance) {
  RAMIFY_EXPECTS(mean >= 0 && mean * mean <= largest_clump_ratio * variance);
  const bool above = total > mean;
  const ClumpLaw law(mean, variance);
  const double tail = above ? tail_from(total, mean, law) : tail_up_to(total, law);
  if (tail >= 0.5) return 0;
  const double z = boost::math::constants::root_two<double>() *
                   boost::math::erfc_inv(2 * std::max(tail, std::numeric_limits<double>::min()));
  return above ? z : -z;
}

}  // namespace ramify
