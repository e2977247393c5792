#pragma once

#include <optional>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/large/large_join.hpp"
#include "ramify/large/large_order_means.hpp"
#include "ramify/large/large_order_moments.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// OrderMeans and OrderMoments of the sizes 0..n: two passes over the same rows.
struct ExactOrders {
  /// Throws Interrupted.
  ExactOrders(const Model& model, Size n, const Cancellation& cancellation);
  ExactOrders(const ExactOrders&) = delete;  // the moments refer to the means
  ExactOrders& operator=(const ExactOrders&) = delete;
  ExactOrders(ExactOrders&&) = delete;
  ExactOrders& operator=(ExactOrders&&) = delete;
  ~ExactOrders() = default;

  OrderMeans means;
  std::optional<OrderMoments> moments;
};

/// The law of the order S and the mean counts on one grid of sizes, without the second and third solution by
/// which LargeOrders tells its errors.
///
/// The grid begins at 256, later for a lopsided binomial split; its step is 0.08 in log n, 0.04 or
/// less where splits are concentrated and laws swing with log n. Accuracy: stream_counts.hpp. Cost: some 0.05
/// s to 10^9.
class OrderMeansGrid {
 public:
  /// @param model   with large laws (large_reach.hpp)
  /// @param leaves  n + 1 of the largest tree that is asked for
  /// @param exact   of the sizes 0..exact_to(model). Throws Interrupted.
  OrderMeansGrid(const Model& model, double leaves, const OrderMeans& exact,
                 const Cancellation& cancellation);

  /// The sizes that are exact, from 0 up.
  static Size exact_to(const Model& model);

  const SizeGrid& grid() const { return grid_; }
  const CompressedRows& rows() const { return rows_; }
  const LargeJoin& strahler() const { return strahler_; }
  const LargeOrderMeans& means() const { return means_; }

 private:
  SizeGrid grid_;
  CompressedRows rows_;
  LargeJoin strahler_;
  LargeOrderMeans means_;
};

/// Trees of one order, among those of one size.
struct OrderOutcome {
  std::size_t order;
  double probability;
  std::vector<double> nodes, streams;  ///< E[N_k | S], E[M_k | S], k = 1..order, leaf order 0
};

/// OrderMeansGrid, and second moments of the counts. Cost: 0.02 to 0.2 s to 10^9.
class OrderGrid {
 public:
  /// As of OrderMeansGrid. Throws Interrupted.
  OrderGrid(const Model& model, double leaves, const Cancellation& cancellation);

  const LargeJoin& strahler() const { return on_grid_.strahler(); }
  const LargeOrderMeans& means() const { return on_grid_.means(); }
  const LargeOrderMoments& moments() const { return moments_; }

  /// The orders that trees of so many leaves have with a probability of 1e-9 or more, lowest first.
  /// @param leaves  more than the grid's table has, and not more than its largest
  std::vector<OrderOutcome> orders(double leaves) const;

 private:
  ExactOrders exact_;
  OrderMeansGrid on_grid_;
  LargeOrderMoments moments_;
};

}  // namespace ramify
