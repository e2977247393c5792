#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ramify/law/balance_law.hpp"
#include "ramify/law/depth_law.hpp"
#include "ramify/law/fill_level_law.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/moments.hpp"
#include "ramify/law/node_sum_law.hpp"
#include "ramify/law/order_means.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/law/strahler_law.hpp"

namespace ramify {

/// P(X = first + i), i = 0, 1, ...
struct FiniteLaw {
  double first;
  std::vector<double> probabilities;
};

/// The exact mean and variance of a table's columns, and their laws, for one model and every n up to the
/// smaller of largest_n and law_limit(model).
///
/// A law is computed when it is first asked for, up to the n asked for, and kept. For use by one thread at a
/// time.
class ExactMeans {
 public:
  ExactMeans(const Model& model, Size largest_n);
  ExactMeans(const ExactMeans&) = delete;  // order_moments_ refers to orders_
  ExactMeans(ExactMeans&&) = delete;
  ExactMeans& operator=(const ExactMeans&) = delete;
  ExactMeans& operator=(ExactMeans&&) = delete;
  ~ExactMeans() = default;

  /// The largest n it answers for.
  Size largest_n() const { return largest_n_; }

  /// @param column  as in StatisticSet::columns: "strahler", "height", "nodes_3". Nothing where n >
  /// largest_n() or the column has no exact law here: ratios, width. nodes_k and streams_k have the mean only
  /// where n > order_moments_limit(model).
  std::optional<Moments> moments(std::string_view column, Size n) const;

  /// The whole law of a column. Nothing where n > largest_n() or only moments are known.
  std::optional<FiniteLaw> law(std::string_view column, Size n) const;

 private:
  template <class Law>
  const Law& extended(Law& law, Size n) const;
  /// @param of  what the law is constructed with, if it is new; largest_n() if left out and the law wants it
  template <class Law, class... Of>
  const Law& known(std::optional<Law>& law, Size n, Of... of) const;

  Moments of_count(Size n, OrderCount count) const;

  Size largest_n_;
  Size largest_n_with_variances_;
  mutable StoredSplitRows rows_;
  mutable std::optional<StrahlerLaw> strahler_;
  mutable std::optional<HeightLaw> height_;
  mutable std::optional<DepthLaw> depth_, external_depth_;
  mutable std::optional<NodeSumLaw> path_length_, sackin_, colless_;
  mutable std::optional<FillLevelLaw> fill_level_;
  mutable std::optional<BalanceLaw> balance_;
  mutable std::optional<OrderMeans> orders_;
  mutable std::optional<OrderMoments> order_moments_;
};

}  // namespace ramify
