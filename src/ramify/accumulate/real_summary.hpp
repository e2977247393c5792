#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace ramify {

/// Summary of real numbers, kept in the order they were added: merge blocks in a fixed order and every sum is
/// the same. NaN, which says that there is no value, is passed over.
class RealSummary {
 public:
  void add(double value) {
    if (!std::isnan(value)) values_.push_back(value);
  }
  void merge(const RealSummary& later) {
    values_.insert(values_.end(), later.values_.begin(), later.values_.end());
  }

  /// In the order they were added.
  const std::vector<double>& values() const { return values_; }
  std::uint64_t count() const { return values_.size(); }
  /// NaN without values.
  double mean() const;
  /// Unbiased, in two passes; 0 for fewer than two values.
  double variance() const;
  /// The smallest value v with P(X <= v) >= level for each level, ascending levels in (0,1]. count() >= 1.
  std::vector<double> quantiles(const std::vector<double>& levels) const;
  /// Linear interpolation between the order statistics (Hyndman and Fan 1996, type 7), levels in [0,1].
  /// count() >= 1.
  std::vector<double> interpolated_quantiles(const std::vector<double>& levels) const;

  friend bool operator==(const RealSummary&, const RealSummary&) = default;

 private:
  std::vector<double> sorted() const;

  std::vector<double> values_;
};

}  // namespace ramify
