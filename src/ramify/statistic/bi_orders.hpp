#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {

/// How many nodes have children of the orders (high, low): the bi-orders (B13) of which the ramification
/// matrix (B14) and the Tokunaga numbers (Tokunaga 1978) are made. Leaf order 0.
class BiOrderCounts {
 public:
  /// Nodes whose two children of highest order have the orders high >= low.
  std::uint64_t joined(std::size_t high, std::size_t low) const { return at(joined_, high, low); }

  /// Streams of order low that end in the side of a stream of order high > low.
  std::uint64_t side_branches(std::size_t low, std::size_t high) const {
    return at(joined_, high, low) + at(further_, high, low);
  }

  /// Nodes of order k with two children or more: of bi-order (k, j), j < k, or (k-1, k-1).
  std::uint64_t nodes(std::size_t k) const {
    std::uint64_t sum = joined(k - 1, k - 1);
    for (std::size_t j = 0; j < k; ++j) sum += joined(k, j);
    return sum;
  }

  void add_joined(std::size_t high, std::size_t low) { ++place(joined_, high, low); }
  void add_further(std::size_t high, std::size_t low) { ++place(further_, high, low); }

 private:
  using Triangle = std::vector<std::uint64_t>;  // (high, low) at high (high+1)/2 + low

  static std::size_t index(std::size_t high, std::size_t low) { return high * (high + 1) / 2 + low; }
  static std::uint64_t at(const Triangle& counts, std::size_t high, std::size_t low) {
    const std::size_t i = index(high, low);
    return i < counts.size() ? counts[i] : 0;
  }
  std::uint64_t& place(Triangle& counts, std::size_t high, std::size_t low) {
    const std::size_t i = index(high, low);
    if (i >= counts.size()) counts.resize(index(high + 1, 0), 0);
    return counts[i];
  }

  Triangle joined_, further_;
};

/// Horton-Strahler orders with the bi-orders of all nodes, from which the counts of HortonStrahler follow: of
/// the streams of order k every one begins at a node of bi-order (k-1, k-1).
///
/// In a node of three children or more the two of highest order make the bi-order; every other one is a side
/// branch of the node's stream. One-child nodes have no bi-order.
class BiOrders {
 public:
  using Value = std::uint8_t;
  using Counts = HortonStrahler::Counts;

  Value external() {
    ++externals_;
    return 0;
  }

  template <class Label, class Labels>
  Value join(const Label&, const Labels&, const Pair<Value>& orders) {
    const auto [low, high] = std::minmax(orders[0], orders[1]);
    counts_.add_joined(high, low);
    return static_cast<Value>(high + (high == low ? 1 : 0));
  }

  template <class Label, class Labels>
  Value join(const Label&, const Labels&, std::span<const Value> orders) {
    const Value order = join_orders(orders).order;
    if (orders.size() < 2) {
      ++one_child_[order];
      return order;
    }
    std::vector<Value> descending(orders.begin(), orders.end());
    std::ranges::sort(descending, std::greater<>());
    counts_.add_joined(descending[0], descending[1]);
    for (std::size_t i = 2; i < descending.size(); ++i) counts_.add_further(order, descending[i]);
    return order;
  }

  const BiOrderCounts& counts() const { return counts_; }

  /// Nodes of order k.
  Counts nodes() const {
    Counts nodes = one_child_;
    nodes[0] += externals_;
    for (std::size_t k = 1; k < nodes.size(); ++k) nodes[k] += counts_.nodes(k);
    return nodes;
  }

  /// Streams of order k.
  Counts streams() const {
    Counts streams{};
    streams[0] = externals_;
    for (std::size_t k = 1; k < streams.size(); ++k) streams[k] = counts_.joined(k - 1, k - 1);
    return streams;
  }

 private:
  BiOrderCounts counts_;
  Counts one_child_{};
  std::uint64_t externals_ = 0;
};

}  // namespace ramify
