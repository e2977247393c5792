#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "support/goodness.hpp"
#include <boost/math/distributions/binomial.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/fit/family_fit.hpp"

namespace ramify::test {

/// What is known to fall short (docs/validation.md says so).
struct Shortfall {
  bool is_biased = false;       ///< perhaps by more than most_bias
  bool is_wide = false;         ///< intervals hold the truth more often than 95 %
  double least_covered = 0.95;  ///< or less often, but so often at least
};

/// Fits of one number whose truth is known: the bias of the estimate in its standard deviations, how many
/// 95 % intervals hold the truth.
class RecoveredNumber {
 public:
  static constexpr double most_bias = 0.2;  // of the estimate's standard deviation
  static constexpr double cases = 200;      // over which the level is simultaneous

  explicit RecoveredNumber(double truth) : truth_(truth) {}

  void add(const FittedParameter& found) {
    const bool holds =
        (found.lower_open || found.lower <= truth_) && (found.upper_open || truth_ <= found.upper);
    covered_ += holds ? 1 : 0;
    sets_ += 1;
    sum_ += found.estimate - truth_;
    squares_ += (found.estimate - truth_) * (found.estimate - truth_);
  }

  double bias() const {
    const double mean = sum_ / sets_;
    return mean / std::sqrt(squares_ / sets_ - mean * mean);
  }
  double covered() const { return covered_ / sets_; }

  /// @param more  to print beside it
  void expect(const std::string& name, const Shortfall& shortfall, const std::string& more = "") const {
    fmt::print("  {}: {:.0f} sets, bias {:.3f} sd, covered {:.3f}{}\n", name, sets_, bias(), covered(), more);
    if (!shortfall.is_biased) {
      EXPECT_LT(std::abs(bias()), most_bias) << name;
    }
    if (shortfall.is_wide || shortfall.least_covered < 0.95) {
      EXPECT_GT(covered(), shortfall.least_covered) << name;
      return;
    }
    const double p_value = binomial_p();
    EXPECT_TRUE(agrees({name + ", coverage", covered_, 0, p_value}));
    EXPECT_GT(p_value, 0.01 / cases) << name << ": simultaneous at 1 % over the cases";
  }

 private:
  /// Two-sided: so many of the sets or a number as unlikely.
  double binomial_p() const {
    const boost::math::binomial_distribution<> law(sets_, 0.95);
    return std::min(
        1.0, 2 * std::min(cdf(law, covered_), covered_ < 1 ? 1.0 : cdf(complement(law, covered_ - 1))));
  }

  double truth_, sets_ = 0, covered_ = 0, sum_ = 0, squares_ = 0;
};

/// "tree_aldous_m1p5_60"
inline std::string case_name(std::string name) {
  for (char& c : name)
    if (c == '.' || c == '-') c = c == '.' ? 'p' : 'm';
  return name;
}

}  // namespace ramify::test
