#pragma once

#include <memory>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/large/refined.hpp"
#include "ramify/model/model.hpp"
#include "ramify/statistic/order_count.hpp"

namespace ramify {

/// The largest n of variances and covariances of the counts (large_order_moments.hpp says why).
inline constexpr double largest_covariance_size = 1e15;

/// E N_k and E M_k, nodes and streams of order k, leaf order 0, of a split model at sizes to 1e300, and their
/// covariances to 1e15, with their errors (Refined). Cost: some 0.3 s to 1e9; of covariances 2 s, of catalan
/// 10 s, and 23 s to 1e12, where their errors are 2e-7 of n+1.
class LargeOrders {
 public:
  /// Throws Interrupted.
  /// @param model  with large laws (large_reach.hpp)
  /// @param sizes  those that are asked for, at most largest_law_size
  LargeOrders(const Model& model, const std::vector<double>& sizes, const Cancellation& cancellation = {});
  LargeOrders(const LargeOrders&) = delete;
  LargeOrders(LargeOrders&&) noexcept;
  LargeOrders& operator=(const LargeOrders&) = delete;
  LargeOrders& operator=(LargeOrders&&) noexcept;
  ~LargeOrders();

  /// Of the orders 0..floor(log2(n+1)); n from large_law_table(model) on.
  std::vector<Approximation> means(double n, OrderCount::Of of) const;

  /// Of orders 0, 1, ..., up to any; n like that of the means, at most largest_covariance_size. The first
  /// call computes those of all sizes.
  /// Throws Error where n is larger, Interrupted.
  Approximation covariance(double n, OrderCount a, OrderCount b, const Cancellation& cancellation = {});
  Approximation variance(double n, OrderCount count, const Cancellation& cancellation = {});

 private:
  class Solution;
  void solve_covariances(const Cancellation& cancellation);
  static Approximation covariance_of(const Refined<Solution>& solutions, double n, OrderCount a,
                                     OrderCount b);
  static bool covariances_are_good(const Refined<Solution>& solutions, double n);
  static std::vector<Approximation> means_of(const Refined<Solution>& solutions, double n, OrderCount::Of of);

  Model model_;
  std::vector<double> sizes_;
  std::unique_ptr<Refined<Solution>> solutions_;
  std::unique_ptr<Refined<Solution>> with_covariances_;  ///< made when asked for
};

}  // namespace ramify
