#pragma once

#include <algorithm>
#include <vector>

#include "ramify/law/order_means.hpp"

namespace ramify {

/// Means, variances and covariances of the node and stream counts N_k, M_k of all orders, and their means
/// given the order of the root.
///
/// With Y = X - slope (n+1) for every count X (n+1 adds up over the children, so Y obeys the same join) and e
/// the indicators by which the root adds to the counts, E[Y_a Y_b] of a node is, over its splits, that of
/// both children, plus both products of their means, plus E[e_a (Y_L + Y_R)_b], the same with a and b
/// exchanged, and E[e_a e_b]; the middle terms come from y_a(n,s) = E[Y_a; S = s]. With slopes near E X/n, Y
/// stays as small as its standard deviation and nothing cancels: absolute error of a covariance about 1e-13
/// n. D = 2 floor(log2(n+1)) counts take memory O(n D^2) and time O(n^2 D^2), a vectorised half nanosecond a
/// step.
class OrderMoments {
 public:
  /// @param means  of the same model, with every size up to largest_n; must outlive this
  OrderMoments(const OrderMeans& means, Size largest_n);

  Size sizes() const { return sizes_; }

  /// Adds the size row.n == sizes() <= largest_n.
  void extend(const SplitRow& row);

  double mean(Size n, OrderCount count) const { return means_->mean(n, count); }
  double covariance(Size n, OrderCount a, OrderCount b) const;

  /// Not below 0, where rounding may leave the covariance of a count with itself.
  double variance(Size n, OrderCount count) const { return std::max(0.0, covariance(n, count, count)); }

  /// E[X | S = order]; NaN where no tree of that size has that order.
  double mean_given_order(Size n, OrderCount count, std::size_t order) const;

 private:
  /// One count a: what is kept of Y_a, size by size.
  struct Count {
    double slope;
    std::vector<SizeSeries> by_order;  ///< E[Y; S = s] at index s+1
    std::vector<SizeSeries> below;     ///< E[Y; S < s]
    SizeSeries all;                    ///< E[Y]
  };
  /// E[(Y_L + Y_R)_a; S = s], and the part of it where the root begins a stream of order s.
  struct Joined {
    double all, born;
  };

  std::size_t index(OrderCount count) const;
  std::size_t order_of(std::size_t index) const { return index % top_ + 1; }
  bool counts_streams(std::size_t index) const { return index >= top_; }
  Joined joined(const SplitRow& row, const Count& count, std::size_t order) const;
  double added(std::size_t a, std::size_t order, Size n) const;
  double root_product(std::size_t a, std::size_t b, const std::vector<std::vector<Joined>>& joined) const;
  static void append(Count& count, const std::vector<double>& by_order);
  const SizeSeries& at(std::size_t order) const;
  const SizeSeries& below(std::size_t order) const;

  const OrderMeans* means_;
  std::size_t top_;  ///< K
  Size sizes_ = 0;
  std::vector<Count> counts_;                    ///< nodes 1..K, streams 1..K
  std::vector<std::vector<SizeSeries>> second_;  ///< E[Y_a Y_b], b <= a
  std::vector<double> born_;                     ///< P(the root begins a stream of order s) of the last row
};

}  // namespace ramify
