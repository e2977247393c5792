#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ramify/large/large_law.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/statistic/statistic_set.hpp"

namespace ramify {

/// What the laws of a table take, before any is computed.
struct FiniteMeansCost {
  double seconds;  ///< on one core, right to a factor of 3
  /// Statistics whose laws would take too long at the largest size, and are left out there.
  std::vector<std::string_view> left_out;
};

/// The mean and variance of a table's columns at given sizes of any magnitude, and at those between them, for
/// one split model: exact up to law_limit(model), beyond on a grid (LargeLaw), with errors below what any
/// sample could tell; where some of them lie beyond, sizes between are on the grid as soon as there is one.
///
/// Laws are computed when they are first asked for, for all the sizes, and kept. For use by one thread at a
/// time.
class FiniteMeans {
 public:
  /// A law on a grid that takes longer than this is left out.
  static constexpr double longest_seconds = 20;

  FiniteMeans(const Model& model, const std::vector<Size>& sizes);

  /// Of the same model and sizes and all columns of the statistics.
  static FiniteMeansCost cost(const Model& model, const std::vector<Size>& sizes,
                              const StatisticSet& statistics);

  /// Nothing where n lies above the given sizes, or between law_limit and the first size of the grid,
  /// where the statistic has no law, where the model has none beyond law_limit, or where it would take longer
  /// than longest_seconds. The variance is NaN where only the mean is known, as of counts above the
  /// largest of the given sizes that has an exact law.
  std::optional<Moments> moments(const StatisticColumn& column, Size n) const;

 private:
  std::optional<Moments> large_moments(const Recurrence& recurrence, const OrderPlace& place, Size n) const;
  Moments of_count(OrderCount count, double n) const;

  Model model_;
  std::vector<double> large_sizes_;  ///< those beyond the exact laws
  ExactMeans exact_;
  mutable std::vector<std::pair<Recurrence, LargeLaw>> laws_;
  mutable std::optional<LargeOrders> orders_;
};

}  // namespace ramify
