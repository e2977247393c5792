#pragma once

#include <vector>

#include "ramify/law/split_row.hpp"

namespace ramify {

/// The probability of one event for trees of size 0, 1, 2, ..., which small trees cannot meet: the leading
/// zeros are not stored.
class TailSeries {
 public:
  /// The sizes 0..sizes()-1 are known.
  Size sizes() const { return first_ + values_.size(); }

  /// Adds the size sizes().
  void append(double probability);

  /// Of a size n < sizes().
  double operator[](Size n) const { return n < first_ ? 0 : values_[n - first_]; }

 private:
  friend double over_either_child(const SplitRow& row, const TailSeries& event);

  Size first_ = 0;   ///< the smallest size at which it is not 0
  Size likely_ = 0;  ///< no size below reaches 2^-54
  std::vector<double> values_;
};

/// The sum over the row of weight * P(one child at least meets the event): a + b (1 - a), or a + b where the
/// rest would be rounded away. Positive terms. O(row), vectorised.
/// @param event  with every size below row.n
double over_either_child(const SplitRow& row, const TailSeries& event);

}  // namespace ramify
