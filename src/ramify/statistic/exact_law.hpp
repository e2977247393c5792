#pragma once

#include <optional>
#include <span>
#include <variant>

#include "ramify/statistic/join_rule.hpp"
#include "ramify/statistic/order_count.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

// How the exact law of a statistic of split trees follows from size to size, as data: law/ computes it,
// large/ beyond some thousand nodes.

/// The largest n of any law.
inline constexpr double largest_law_size = 1e300;

/// Nothing random: n + more.
struct KnownBySize {
  Size more;
  friend bool operator==(const KnownBySize&, const KnownBySize&) = default;
};

/// A value of at most floor(log2(n+1)), 0 of an external node, joined by a rule.
struct BoundedJoin {
  const JoinRule* rule;
  friend bool operator==(const BoundedJoin&, const BoundedJoin&) = default;
};

/// 1 + the larger of the children's values; 1 of an external node.
struct LongestPath {
  friend bool operator==(const LongestPath&, const LongestPath&) = default;
};

/// Nodes on a walk down to a child of size i with probability proportional to i + weight_of_none.
struct WeightedWalk {
  Size weight_of_none;
  friend bool operator==(const WeightedWalk&, const WeightedWalk&) = default;
};

/// What a node costs, from the numbers of external nodes of its children; at large sizes, where laws are held
/// on a grid, these need not be whole (large/).
using Toll = double (*)(std::span<const double> leaves);

/// The sum over all internal nodes of a toll, or, averaged, the toll of the root plus the mean over its
/// children: Y = toll + (Y_1 + ... + Y_k)/k. Y = 0 of an external node. Mean and variance are known.
struct NodeSum {
  Toll toll;
  bool averaged = false;
  friend bool operator==(const NodeSum&, const NodeSum&) = default;
};

/// The count of nodes or of streams of an order: that of the column, or always the same. Mean and
/// covariances.
struct CountOfOrder {
  OrderCount::Of of;
  std::optional<std::size_t> order = std::nullopt;

  OrderCount at(std::size_t order_of_column) const { return {of, order.value_or(order_of_column)}; }
  friend bool operator==(const CountOfOrder&, const CountOfOrder&) = default;
};

/// Nothing where a statistic has no such recurrence: ratios, the width.
using Recurrence =
    std::variant<std::monostate, KnownBySize, BoundedJoin, LongestPath, WeightedWalk, NodeSum, CountOfOrder>;

/// What a recurrence gives.
enum class Known { nothing, value, moments, law };
constexpr Known known_of(const Recurrence& recurrence) {
  if (std::holds_alternative<std::monostate>(recurrence)) return Known::nothing;
  if (std::holds_alternative<KnownBySize>(recurrence)) return Known::value;
  const bool sums =
      std::holds_alternative<NodeSum>(recurrence) || std::holds_alternative<CountOfOrder>(recurrence);
  return sums ? Known::moments : Known::law;
}

/// X = factor Y + shift.
struct AffineMap {
  double factor = 1, shift = 0;
};

/// The exact law of a statistic X: that of Y by a recurrence, and how X comes from Y at size n.
struct ExactLaw {
  Recurrence recurrence = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
  AffineMap (*map)(double n) = [](double) { return AffineMap(); };
};

}  // namespace ramify
