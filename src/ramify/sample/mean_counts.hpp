#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "ramify/core/contract.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {

/// Horton-Strahler orders, with counts that are exact for every node that is grown and expected for what is
/// grafted: a grafted subtree has an order from its exact law, and the mean counts of subtrees of that size
/// and order.
///
/// The order of a tree has its exact law, and the counts of a tree their exact expectation given all orders
/// of the grafted subtrees and of the nodes above them: only the spread of the lower counts around it is left
/// out. Counts are kept in units of 2^-16, so that their sum does not depend on the order of adding. For
/// trees to 2^47.
class MeanCounts {
 public:
  using Value = HortonStrahler::Value;
  using Counts = HortonStrahler::Counts;

  static constexpr Size largest_grafted = Size{1} << 20;
  static constexpr std::size_t grafted_orders = std::bit_width(largest_grafted + 1) - 1;

  /// Mean counts of nodes, then of streams, of the orders 1..grafted_orders.
  class Tally {
   public:
    static Tally of(std::span<const double> nodes, std::span<const double> streams) {
      RAMIFY_EXPECTS(nodes.size() <= grafted_orders && streams.size() <= grafted_orders);
      Tally tally;
      for (std::size_t k = 0; k < nodes.size(); ++k) tally.scaled_[k] = scaled(nodes[k]);
      for (std::size_t k = 0; k < streams.size(); ++k) tally.scaled_[grafted_orders + k] = scaled(streams[k]);
      return tally;
    }

    Tally& operator+=(const Tally& other) {
      for (std::size_t i = 0; i < scaled_.size(); ++i) scaled_[i] += other.scaled_[i];
      return *this;
    }

    std::uint64_t nodes(std::size_t order) const { return rounded(0, order); }
    std::uint64_t streams(std::size_t order) const { return rounded(grafted_orders, order); }

   private:
    static constexpr int fraction_bits = 16;
    static std::uint64_t scaled(double count) {
      return static_cast<std::uint64_t>(std::llround(std::ldexp(count, fraction_bits)));
    }
    std::uint64_t rounded(std::size_t first, std::size_t order) const {
      if (order > grafted_orders) return 0;
      return (scaled_[first + order - 1] + (1u << (fraction_bits - 1))) >> fraction_bits;
    }

    std::array<std::uint64_t, 2 * grafted_orders> scaled_{};
  };

  Value external() { return grown_.external(); }

  template <class Label, class Labels, class Values>
  Value join(const Label& label, const Labels& labels, const Values& orders_below) {
    return grown_.join(label, labels, orders_below);
  }

  void add_tally(Size n, const Tally& tally) {
    grafted_ += tally;
    externals_ += n + 1;
  }

  /// Nodes of order k, rounded.
  Counts nodes() const {
    Counts nodes = grown_.nodes();
    nodes[0] += externals_;
    for (std::size_t k = 1; k <= grafted_orders; ++k) nodes[k] += grafted_.nodes(k);
    return nodes;
  }

  /// Streams of order k, rounded.
  Counts streams() const {
    Counts streams = grown_.streams();
    streams[0] += externals_;
    for (std::size_t k = 1; k <= grafted_orders; ++k) streams[k] += grafted_.streams(k);
    return streams;
  }

 private:
  HortonStrahler grown_;
  Tally grafted_;
  std::uint64_t externals_ = 0;  // of grafted subtrees
};

}  // namespace ramify
