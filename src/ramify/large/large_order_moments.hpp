#pragma once

#include <vector>

#include "ramify/large/large_order_means.hpp"
#include "ramify/law/order_moments.hpp"

namespace ramify {

/// Covariances of the node and stream counts N_k, M_k of all orders at sizes of any magnitude.
///
/// Every count is taken about its own mean, Z = X - E X(leaves), so that nothing is larger than a standard
/// deviation and nothing cancels. For children of x and y leaves of z = x + y
///
///     Z(z) = Z(x) + Z(y) + D + e,   D = E X(x) + E X(y) - E X(z),
///
/// e = 1 where the root adds to the count. The children are independent, hence Cov_ab(z) is the sum over the
/// row of Cov_ab(x) + Cov_ab(y) + E[(D + e)_a (D + e)_b] + E[e_a (Z(x) + Z(y))_b] + the same with a and b
/// exchanged. The last two follow from h(z; s) = E[Z; S >= s], which obeys the rule of P(S >= s), Strahler's
/// upper, with one child's probability replaced by its h. Covariances are held over leaves.
///
/// D, a difference of means of some leaves x 1e-16 each, makes an error of (1e-16 leaves)^2: to 1e15 leaves
/// it does not matter. Cost: places of the grid x orders^2 x places that a row refers to, some 700, 0.3 ns
/// each.
class LargeOrderMoments {
 public:
  /// @param table     of the same model, with the sizes 0..grid.table_size()
  /// @param strahler  the law of the order on the same grid
  /// @param means     on it too; all three must outlive this
  /// Throws Interrupted.
  LargeOrderMoments(const SizeGrid& grid, const CompressedRows& rows, const OrderMoments& table,
                    const LargeJoin& strahler, const LargeOrderMeans& means,
                    const Cancellation& cancellation);
  LargeOrderMoments(const LargeOrderMoments&) = delete;
  LargeOrderMoments& operator=(const LargeOrderMoments&) = delete;
  LargeOrderMoments(LargeOrderMoments&&) = delete;
  LargeOrderMoments& operator=(LargeOrderMoments&&) = delete;
  ~LargeOrderMoments();

  /// 0 where one of the orders is 0 or out of reach.
  double covariance(double leaves, OrderCount a, OrderCount b) const;

  /// E[X - E X; S >= order] of a count X; 0 where no tree, or every tree, has such an order.
  double about_mean(double leaves, OrderCount count, std::size_t order) const;

 private:
  struct Place;
  class Row;

  Place empty_place(std::size_t place) const;
  void fill_from(const OrderMoments& table);
  void extend(std::size_t place, PlacedRows& rows);

  const SizeGrid* grid_;
  const TailTable* tails_;
  const LargeOrderMeans* means_;
  std::vector<Place> places_;
};

}  // namespace ramify
