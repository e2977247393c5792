#pragma once

#include <algorithm>
#include <vector>

#include "ramify/law/conditional_order_means.hpp"

namespace ramify {

/// Means, variances and covariances of the node and stream counts N_k, M_k of all orders.
///
/// With the centred counts Y of ConditionalOrderMeans and e the indicators by which the root adds to the
/// counts, E[Y_a Y_b] of a node is, over its splits, that of both children, plus both products of their
/// means, plus E[e_a (Y_L + Y_R)_b], the same with a and b exchanged, and E[e_a e_b]; the middle terms come
/// from y_a(n,s) = E[Y_a; S = s]. As Y is as small as its standard deviation, nothing cancels: absolute error
/// of a covariance about 1e-13 n. D = 2 floor(log2(n+1)) counts take memory O(n D^2) and time O(n^2 D^2), a
/// vectorised half nanosecond a step.
class OrderMoments {
 public:
  /// @param means  of the same model, with every size up to largest_n; must outlive this
  OrderMoments(const OrderMeans& means, Size largest_n);

  Size sizes() const { return given_order_.sizes(); }

  /// Adds the size row.n == sizes() <= largest_n.
  void extend(const SplitRow& row);

  double mean(Size n, OrderCount count) const { return means_->mean(n, count); }
  double covariance(Size n, OrderCount a, OrderCount b) const;

  /// Not below 0, where rounding may leave the covariance of a count with itself.
  double variance(Size n, OrderCount count) const { return std::max(0.0, covariance(n, count, count)); }

  const ConditionalOrderMeans& given_order() const { return given_order_; }

 private:
  double root_product(std::size_t a, std::size_t b, const ConditionalOrderMeans::Step& step) const;

  const OrderMeans* means_;
  ConditionalOrderMeans given_order_;
  std::vector<std::vector<SizeSeries>> second_;  ///< E[Y_a Y_b], b <= a
};

}  // namespace ramify
