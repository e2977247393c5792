#pragma once

#include <array>
#include <cstdint>

#include "ramify/core/contract.hpp"
#include "ramify/statistic/small_counts.hpp"
#include "ramify/statistic/strahler.hpp"
#include "ramify/tree/grammar.hpp"
#include "ramify/tree/largest_order.hpp"

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

  /// The nodes of orders 1..4 by what they do: keep the order of a child, or begin a stream.
  struct Tally {
    SmallCounts keep, begin;

    Tally& operator+=(const Tally& other) {
      keep += other.keep;
      begin += other.begin;
      return *this;
    }
    friend auto operator<=>(const Tally&, const Tally&) = default;
  };
  /// A tree of order 5 has 31 internal nodes.
  static constexpr Size largest_tallied = 30;

  Value external() {
    ++externals_;
    return 0;
  }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& orders_below) {
    const JoinedOrder node = join_orders(orders_below);
    ++counts_[2 * std::size_t{node.order} + node.begins];
    return node.order;
  }

  Tally take_tally() {
    Tally tally;
    for (std::size_t k = 1; k <= SmallCounts::largest_order; ++k) {
      tally.keep.increment(k, counts_[2 * k]);
      tally.begin.increment(k, counts_[2 * k + 1]);
    }
    counts_.fill(0);
    return tally;
  }

  void add_tally(Size n, const Tally& tally) {
    RAMIFY_EXPECTS(n <= largest_tallied);
    externals_ += n + 1;
    grafted_ += tally;
    if (++grafts_ == grafts_that_fit) unpack();
  }

  /// Nodes of order k.
  Counts nodes() const {
    Counts nodes{};
    nodes[0] = externals_ + counts_[kept];  // one-child nodes above a single external one
    for (std::size_t k = 1; k < orders; ++k) nodes[k] = count<kept>(k) + count<begun>(k);
    return nodes;
  }

  /// Streams of order k.
  Counts streams() const {
    Counts streams{};
    streams[0] = externals_;
    for (std::size_t k = 1; k < orders; ++k) streams[k] = count<begun>(k);
    return streams;
  }

  /// The largest order a strict binary tree with n internal nodes can have: floor(log2(n+1)).
  static std::size_t largest_order(Size n) { return largest_strahler_order(n + 1); }

 private:
  // A node keeps the order of a child, or it begins a stream of an order of its own: one counter for either.
  static constexpr std::size_t kept = 0, begun = 1;
  static constexpr std::uint32_t grafts_that_fit = SmallCounts::largest_count / largest_tallied;

  template <std::size_t which>
  std::uint64_t count(std::size_t k) const {
    const SmallCounts& grafted = which == begun ? grafted_.begin : grafted_.keep;
    return counts_[2 * k + which] + (k <= SmallCounts::largest_order ? grafted[k] : 0);
  }

  void unpack() {
    for (std::size_t k = 1; k <= SmallCounts::largest_order; ++k) {
      counts_[2 * k + kept] = count<kept>(k);
      counts_[2 * k + begun] = count<begun>(k);
    }
    grafted_ = Tally();
    grafts_ = 0;
  }

  std::array<std::uint64_t, 2 * orders> counts_{};  // of order k: kept at 2k, begun at 2k + 1
  std::uint64_t externals_ = 0;
  Tally grafted_;             // not yet in counts_
  std::uint32_t grafts_ = 0;  // that it holds
};

}  // namespace ramify
