#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace ramify::test {

/// Every statistical test of ramify: fixed seeds, and a right sampler fails one in a million.
inline constexpr double alpha = 1e-6;

/// What a test of goodness of fit says.
struct Goodness {
  std::string what;
  double statistic;
  double degrees;  ///< of freedom; 0 for a z-test
  double p_value;
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  std::uint64_t impossible = 0;  ///< draws that the law excludes
  double deviation = 0;          ///< of a chi-square statistic, by the law of the draws or by the draws
  std::optional<double> expected = {};  ///< its mean, where the law of the draws is known
  // NOLINTEND(readability-redundant-member-init)
};

/// Passes where p >= alpha. Prints statistic, degrees of freedom and p either way.
::testing::AssertionResult agrees(const Goodness& goodness);

/// How likely a negative control rejects at alpha, whatever the seed. Of a chi-square by the normal law with
/// the statistic's mean and deviation, on the safe side, for it is skewed to the right; where the law of the
/// draws is not known, by the least mean that the sample leaves at 99.9 %. Of a z-test likewise; of
/// impossible draws, which come as of a Poisson law, by their least mean.
double least_power(const Goodness& goodness);

/// Of every negative control.
inline constexpr double needed_power = 0.999;

/// Passes where p < alpha and the power is the needed one: the negative control. Decides nothing under a
/// sanitizer (sanitized.hpp).
::testing::AssertionResult rejected(const Goodness& goodness);

/// Pearson's chi-square of counts against probabilities (scaled to sum 1). Neighbouring cells are pooled
/// until each expects `least` at least; a count in a cell of probability 0 gives p = 0.
/// @param truth  of a negative control: the probabilities that the counts have in fact, for its power
Goodness chi_square(const std::string& what, std::span<const std::uint64_t> observed,
                    std::span<const double> probabilities, double least = 5,
                    std::span<const double> truth = {});

/// Counts of the outcomes 0..m-1, and of pairs (order, height) and the like.
using Tally = std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t>;

/// Pearson's chi-square of homogeneity of two samples; cells with fewer than 10 in both together are pooled.
Goodness two_samples(const std::string& what, const Tally& a, const Tally& b);

/// Mean and variance of a sample.
class SampleMean {
 public:
  void add(double value);
  double count() const { return count_; }
  double mean() const { return mean_; }
  double standard_error() const;

 private:
  double count_ = 0;
  double mean_ = 0;
  double squares_ = 0;
};

/// z = (mean - exact) / standard error, two-sided. A sample without spread agrees with its own value only.
Goodness z_test(const std::string& what, const SampleMean& sample, double exact);

/// The same of whole numbers, whose variance is f(1-f) at least, f what the exact mean is above a whole
/// number: a sample in which no rare value was seen does not know it.
Goodness z_test_of_counts(const std::string& what, const SampleMean& sample, double exact);

}  // namespace ramify::test
