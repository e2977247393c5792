#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "ramify/accumulate/estimate.hpp"
#include "ramify/core/int128.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {

/// Sums over trees of the counts of every order, their squares and the products of neighbours: what the
/// pooled ratio and its error need. Counts are of nodes or of streams; keep one object for each.
class OrderTotals {
 public:
  /// Over all trees, of one order k.
  struct Sums {
    int128 counts, squares;
    int128 neighbours;  ///< N_k N_(k+1)

    friend bool operator==(const Sums&, const Sums&) = default;
  };

  OrderTotals() = default;
  /// @param sums  of the orders 0.., as sums() gives them. Throws Error where there are more than a tree has
  OrderTotals(std::uint64_t trees, std::span<const Sums> sums);

  /// Orders 0..top of one tree.
  void add(const HortonStrahler::Counts& counts, std::size_t top);
  void merge(const OrderTotals& other);

  std::uint64_t trees() const { return trees_; }
  /// Orders 0..highest() occurred.
  std::size_t highest() const { return highest_; }
  /// Of the orders 0..highest().
  std::span<const Sums> sums() const { return std::span(sums_).first(highest_ + 1); }

  /// Mean count of order k over the trees.
  Estimate mean(std::size_t k) const;

  /// pooled_ratio: sum of N_k over sum of N_(k+1), k < highest(); standard error by the delta method over
  /// trees (0 for one tree).
  Estimate pooled_ratio(std::size_t k) const;

  friend bool operator==(const OrderTotals&, const OrderTotals&) = default;

 private:
  double variance_of_mean(const int128& sum_a, const int128& sum_b, const int128& sum_ab) const;

  std::array<Sums, HortonStrahler::orders> sums_{};
  std::uint64_t trees_ = 0;
  std::size_t highest_ = 0;
};

}  // namespace ramify
