#pragma once

#include <functional>
#include <variant>

namespace ramify {

// The split laws of large trees: P(left = i) continued from whole numbers to real ones. Sizes are written as
// numbers of leaves (external nodes): left = i+1, right = n-i, both together n+1.

/// log P(left, right) up to a constant of left + right, smooth in both; finite where both are at least 1.
using LogWeight = std::function<double(double left, double right)>;

/// A law whose weights change slowly beside the distance of whole numbers, but for the ends.
struct SmoothSplit {
  LogWeight log_weight;
  bool sums_to_one;  ///< the constant is there: rows sum to 1 as they are, and that they do is a check
};

/// K ~ Binomial(leaves - fewer, p), and K + at_least of the leaves go left.
struct BinomialSplit {
  double p;
  double fewer;
  double at_least;

  /// log P(K = k), other = trials - k. Saddle-point form (Loader 2000): no difference of large numbers, right
  /// to 1e-15 times the distance from the mean in standard deviations squared, at any number of trials.
  /// @param deviation  k - p trials
  static double log_weight(double trials, double p, double deviation);
};

/// Nothing where a law has no weights between the whole numbers.
using RealSplit = std::variant<std::monostate, SmoothSplit, BinomialSplit>;

/// log(Gamma(x+c) / (Gamma(x) x^c)), x > 0, x + c > 0: tends to 0 like c(c-1)/(2x). Absolute error about
/// 1e-15 (1 + |c|) min(1, |c|/x) above x = 20, that of two log-gammas below. O(1).
double log_gamma_excess(double x, double c);

}  // namespace ramify
