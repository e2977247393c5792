#pragma once

#include <cstdint>
#include <map>

namespace ramify {

/// Exact summary of whole numbers: how often each value occurred. Mergeable in any order with the same
/// result.
///
/// Memory: one entry for each distinct value. mean and variance come from exact 128-bit sums, rounded once.
class WholeSummary {
 public:
  void add(std::int64_t value) { ++occurrences_[value]; }
  void add(std::int64_t value, std::uint64_t times) { occurrences_[value] += times; }
  void merge(const WholeSummary& other);

  std::uint64_t count() const;
  double mean() const;
  /// Unbiased (divisor count-1); 0 for fewer than two values.
  double variance() const;
  /// The smallest value v with P(X <= v) >= level, 0 < level <= 1. count() >= 1.
  std::int64_t quantile(double level) const;
  std::int64_t min() const { return occurrences_.begin()->first; }
  std::int64_t max() const { return occurrences_.rbegin()->first; }
  const std::map<std::int64_t, std::uint64_t>& occurrences() const { return occurrences_; }

  friend bool operator==(const WholeSummary&, const WholeSummary&) = default;

 private:
  std::map<std::int64_t, std::uint64_t> occurrences_;
};

}  // namespace ramify
