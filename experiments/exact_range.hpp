#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "ramify/compare/finding.hpp"

namespace ramify {

/// The least and the largest of numbers, and what is known where they are all there are.
class ExactRange {
 public:
  void add(double value) {
    range_.lower = std::fmin(range_.lower, value);
    range_.upper = std::fmax(range_.upper, value);
  }

  double lower() const { return range_.lower; }
  double upper() const { return range_.upper; }

  /// Of a statement that all of them are equal to, above or below a number. Every number was computed.
  /// @param error  a bound of the rounding of each
  Basis basis(double largest_n, std::string method, double error = 0) const {
    return {EvidenceKind::exact,
            Standing::proved,
            (range_.lower + range_.upper) / 2,
            {range_.lower - error, range_.upper + error},
            largest_n,
            std::move(method),
            "larger sizes"};
  }

 private:
  Interval range_{HUGE_VAL, -HUGE_VAL};
};

/// The largest |x_i| where every x_i is known up to an error: of a statement that all of them are 0.
class LargestOf {
 public:
  void add(double value, double error) {
    value_ = std::fmax(value_, std::abs(value));
    lower_ = std::fmax(lower_, std::abs(value) - error);
    upper_ = std::fmax(upper_, std::abs(value) + error);
  }

  double value() const { return value_; }
  /// Of its true value.
  Interval interval() const { return {lower_, upper_}; }

  Basis basis(EvidenceKind evidence, Standing standing, double largest_n, std::string method,
              std::string left_open = "larger sizes") const {
    return {evidence, standing, value_, interval(), largest_n, std::move(method), std::move(left_open)};
  }

 private:
  double value_ = 0, lower_ = 0, upper_ = 0;
};

}  // namespace ramify
