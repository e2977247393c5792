#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "ramify/law/order_means.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/law/split_rows.hpp"
#include "ramify/law/statistic_law.hpp"
#include "ramify/statistic/statistic_info.hpp"

namespace ramify {

/// The exact mean and variance of a table's columns, and their laws, for one model and every n up to the
/// smaller of largest_n and law_limit(model).
///
/// A law is computed when it is first asked for, up to the n asked for, and kept. For use by one thread at a
/// time.
class ExactMeans {
 public:
  /// @param largest_n_with_variances  of counts, which cost the most
  ExactMeans(const Model& model, Size largest_n, Size largest_n_with_variances = max_size);
  ExactMeans(const ExactMeans&) = delete;  // order_moments_ refers to orders_
  ExactMeans(ExactMeans&&) = delete;
  ExactMeans& operator=(const ExactMeans&) = delete;
  ExactMeans& operator=(ExactMeans&&) = delete;
  ~ExactMeans() = default;

  /// The largest n it answers for.
  Size largest_n() const { return largest_n_; }

  /// Nothing where n > largest_n() or the statistic has no exact law: ratios, width. Counts of nodes and
  /// streams have the mean only where n > order_moments_limit(model), or > largest_n_with_variances.
  std::optional<Moments> moments(const StatisticColumn& column, Size n) const;

  /// The whole law of a column. Nothing where n > largest_n() or only moments are known.
  std::optional<FiniteLaw> law(const StatisticColumn& column, Size n) const;

 private:
  template <class Law>
  const Law& extended(Law& law, Size n) const;
  const StatisticLaw& computed(const Recurrence& recurrence, Size n) const;

  Moments of_recurrence(const StatisticColumn& column, Size n) const;
  Moments of_count(Size n, OrderCount count) const;

  Size largest_n_;
  Size largest_n_with_variances_;
  mutable StoredSplitRows rows_;
  mutable std::vector<std::pair<Recurrence, StatisticLaw>> laws_;
  mutable std::optional<OrderMeans> orders_;
  mutable std::optional<OrderMoments> order_moments_;
};

}  // namespace ramify
