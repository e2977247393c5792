#pragma once

#include <vector>

#include "ramify/law/order_means.hpp"

namespace ramify {

/// E[N_k | S] and E[M_k | S]: the mean counts of nodes and streams of order k in trees whose root has order
/// S.
///
/// For every count X it keeps Y = X - slope (n+1) with a slope near E X/n, of which n+1 adds up over the
/// children, so that Y obeys the same join and stays as small as its standard deviation (order_moments.hpp
/// needs that): y(n,s) = E[Y; S = s] is, over the splits, the sum over both children of Y on the event that
/// the two orders join to s, plus the root's own part. Absolute error about 1e-14 n. With K =
/// floor(log2(n+1)): 2K counts, memory O(n K^2), time O(n^2 K^2), for rows of n entries.
class ConditionalOrderMeans {
 public:
  /// @param means  of the same model, with every size up to largest_n; must outlive this
  ConditionalOrderMeans(const OrderMeans& means, Size largest_n);

  Size sizes() const { return sizes_; }

  /// Adds the size row.n == sizes() <= largest_n.
  void extend(const SplitRow& row) { append(step(row)); }

  /// E[X | S = order]; NaN where no tree of that size has that order.
  double mean(Size n, OrderCount count, std::size_t order) const;

  /// E[X - E X; S = order]; 0 where the tree has no such order or X none to count.
  double about_mean(Size n, OrderCount count, std::size_t order) const;

  // What OrderMoments build on. Counts have the indices nodes 1..K, streams 1..K.

  /// E[(Y_L + Y_R)_a; S = s], and the part of it where the root begins a stream of order s.
  struct Joined {
    double all, born;
  };
  /// One size, before it is added.
  struct Step {
    Size n;
    std::vector<std::vector<Joined>> joined;  ///< of count a, order s
    std::vector<double> born;                 ///< P(the root begins a stream of order s)
  };
  Step step(const SplitRow& row) const;
  void append(const Step& step);

  std::size_t counts() const { return counts_.size(); }
  std::size_t index(OrderCount count) const;
  std::size_t largest_order() const { return top_; }
  std::size_t order_of(std::size_t a) const { return a % top_ + 1; }
  bool counts_streams(std::size_t a) const { return a >= top_; }
  double slope(std::size_t a) const { return counts_[a].slope; }
  const SizeSeries& centred(std::size_t a) const { return counts_[a].all; }
  /// E[e_a; S = order], e_a = 1 where the root adds to count a.
  double added(std::size_t a, std::size_t order, const Step& step) const;

 private:
  /// One count a: what is kept of Y_a, size by size.
  struct Count {
    double slope;
    std::vector<SizeSeries> by_order;  ///< E[Y; S = s] at index s+1
    std::vector<SizeSeries> below;     ///< E[Y; S < s]
    SizeSeries all;                    ///< E[Y]
  };

  Joined joined(const SplitRow& row, std::size_t a, std::size_t order, double born) const;
  static void append(Count& count, const std::vector<double>& by_order);
  const SizeSeries& at(std::size_t order) const;
  const SizeSeries& below(std::size_t order) const;

  const OrderMeans* means_;
  std::size_t top_;  ///< K
  Size sizes_ = 0;
  std::vector<Count> counts_;
};

}  // namespace ramify
