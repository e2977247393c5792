#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Horton-Strahler order, and the counts of nodes and of streams of every order (B6-B9). Leaf order 0.
///
/// S(external) = 0; S = max of the children, plus 1 if two or more of them attain it (the k-ary rule B22; for
/// two children max + [equal]). nodes_k counts the nodes of order k (the thesis, 3.1.2); streams_k counts the
/// maximal chains of order k (Horton, Strahler, Viennot and every measured data set): the nodes none of whose
/// children has their order. The sum of nodes_k over k >= 1 is n, nodes_0 = streams_0 = n+1, the top order
/// has one stream, and 2^S <= n+1.
class HortonStrahler {
 public:
  using Value = std::uint8_t;
  static constexpr std::size_t orders = 64;
  using Counts = std::array<std::uint64_t, orders>;

  Value external() {
    ++externals_;
    return 0;
  }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& orders_below) {
    return join_orders(orders_below);
  }

  /// Nodes of order k.
  Counts nodes() const {
    Counts nodes{};
    nodes[0] = externals_;
    for (std::size_t k = 0; k < orders; ++k) nodes[k] += counts_[2 * k + kept] + counts_[2 * k + born];
    return nodes;
  }

  /// Streams of order k.
  Counts streams() const {
    Counts streams{};
    streams[0] = externals_;
    for (std::size_t k = 0; k < orders; ++k) streams[k] += counts_[2 * k + born];
    return streams;
  }

  /// The largest order a tree with n internal nodes can have: floor(log2(n+1)).
  static std::size_t largest_order(Size n) { return static_cast<std::size_t>(std::bit_width(n + 1)) - 1; }

 private:
  // A node keeps the order of a child, or it begins a stream of an order of its own: one counter for either.
  static constexpr std::size_t kept = 0, born = 1;

  Value join_orders(const Pair<Value>& below) {
    const Value left = below[0], right = below[1];
    const Value higher = left > right ? left : right, lower = left > right ? right : left;
    const auto order = static_cast<Value>(higher > lower ? higher : lower + 1);
    ++counts_[2 * std::size_t{order} + static_cast<std::size_t>(order - higher)];
    return order;
  }

  Value join_orders(std::span<const Value> below) {
    Value highest = 0;
    std::size_t attained = 0;
    for (const Value order : below) {
      if (order > highest) {
        highest = order;
        attained = 0;
      }
      attained += order == highest ? 1 : 0;
    }
    const std::size_t origin = attained < 2 ? kept : born;
    const auto order = static_cast<Value>(highest + origin);
    ++counts_[2 * std::size_t{order} + origin];
    return order;
  }

  std::array<std::uint64_t, 2 * orders> counts_{};  // of order k and origin o at 2k + o
  std::uint64_t externals_ = 0;
};

}  // namespace ramify
