#pragma once

#include <memory>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/large/refined.hpp"
#include "ramify/model/model.hpp"
#include "ramify/statistic/order_count.hpp"

namespace ramify {

/// E N_k and E M_k, nodes and streams of order k, leaf order 0, of a split model at sizes to 1e300, with
/// their errors (Refined). Cost: some 0.3 s to 1e9.
class LargeOrders {
 public:
  /// Throws Interrupted.
  /// @param model  with large laws (large_reach.hpp)
  /// @param sizes  those that are asked for, at most largest_law_size
  LargeOrders(const Model& model, const std::vector<double>& sizes, const Cancellation& cancellation = {});
  LargeOrders(LargeOrders&&) noexcept;
  LargeOrders& operator=(LargeOrders&&) noexcept;
  ~LargeOrders();

  /// Of the orders 0..floor(log2(n+1)); n from large_law_table(model) on.
  std::vector<Estimate> means(double n, OrderCount::Of of) const;

 private:
  class Solution;
  static std::vector<Estimate> means_of(const Refined<Solution>& solutions, double n, OrderCount::Of of);
  std::unique_ptr<Refined<Solution>> solutions_;
};

}  // namespace ramify
