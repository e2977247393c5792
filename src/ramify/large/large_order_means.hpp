#pragma once

#include <vector>

#include "ramify/large/large_join.hpp"
#include "ramify/law/order_means.hpp"

namespace ramify {

/// E N_k and E M_k, nodes and streams of order k, leaf order 0, at sizes of any magnitude: the recurrences of
/// OrderMeans on compressed rows, of counts over leaves. Cost: places of the grid x places of a row x orders,
/// some 20 ns each.
class LargeOrderMeans {
 public:
  /// @param table     of the same model, with the sizes 0..grid.table_size()
  /// @param strahler  the law of the order on the same grid; must outlive this
  /// Throws Interrupted.
  LargeOrderMeans(const SizeGrid& grid, const CompressedRows& rows, const OrderMeans& table,
                  const LargeJoin& strahler, const Cancellation& cancellation);

  /// Of k = 0, 1, ..., as far as a tree of that size reaches.
  std::vector<double> nodes(double leaves) const { return scaled(nodes_, leaves); }
  std::vector<double> streams(double leaves) const { return scaled(streams_, leaves); }

  /// Of a place of the grid, over its leaves; 0 for an order that is out of reach.
  double over_leaves(std::size_t place, OrderCount count) const {
    const Values& means = (count.of == OrderCount::Of::nodes ? nodes_ : streams_)[place];
    return count.order < orders_ ? means[count.order] : 0;
  }

 private:
  using Values = std::vector<double>;
  using Counts = std::vector<Values>;  ///< of a place, over the orders

  void fill_from(const OrderMeans& table);
  void extend(std::size_t place, PlacedRows& rows);
  void interpolate(const Counts& counts, const Stencil& stencil, Values& out) const;
  Values scaled(const Counts& counts, double leaves) const;

  const SizeGrid* grid_;
  const LargeJoin* strahler_;
  std::size_t orders_;
  Counts nodes_, streams_;  ///< over leaves
};

}  // namespace ramify
