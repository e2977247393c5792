#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/statistic/exact_law.hpp"
#include "ramify/statistic/fold_set.hpp"
#include "ramify/statistic/tree_measures.hpp"

namespace ramify {

/// A value of a statistic: a whole number or a real one, as StatisticInfo::real says.
union StatisticValue {
  std::int64_t whole;
  double real;
};

/// A whole number that a tree does not have, as NaN is a real one.
inline constexpr std::int64_t no_whole = std::numeric_limits<std::int64_t>::min();

/// A place in a table by orders: (k, 0) of order k, or (high, low) of two orders.
struct OrderPlace {
  std::size_t high = 0, low = 0;
  friend bool operator==(const OrderPlace&, const OrderPlace&) = default;
};

/// The columns that a statistic has for trees whose largest order is K.
enum class Columns {
  one,
  orders,        ///< name_0 .. name_K
  upper_orders,  ///< name_1 .. name_K
  differences,   ///< the same, of a difference of orders
  pairs,         ///< name_i_j, 1 <= i <= K, 0 <= j <= i
  lower_pairs,   ///< name_i_j, 1 <= i <= K, 0 <= j < i
};

/// All that is known of a statistic: what `ramify list statistics` says of it, what is folded for it and how
/// it is read off, its exact law, the trees it is defined for. Compared by address: one object a statistic.
struct StatisticInfo {
  std::string_view name;
  std::string_view convention;  ///< base, what is counted
  std::string_view description;
  std::string_view source;
  bool real;      ///< a real number, NaN where a tree has none; else a whole one (no_whole), summed exactly
  Columns shape;  ///< one column, or one for each order or pair of orders
  FoldSet folds;  ///< what it is read off; nothing where n says it
  StatisticValue (*value)(const TreeMeasures&, OrderPlace place);
  ExactLaw law = {};          ///< of split trees
  Toll toll = nullptr;        ///< summed over the nodes for it, where it is read off such a sum
  bool needs_binary = false;  ///< says nothing of nodes with three children or more
  bool from_streams = false;  ///< follows from the counts of streams alone
  bool is_order = false;      ///< its value is an order, leaf order 0

  /// "strahler", or "nodes_0..nodes_K".
  std::string columns() const;

  /// "Horton-Strahler number: order of the root (strahler)": heads a picture; a long description ends at its
  /// colon.
  std::string title() const;

  /// One column for each pair of orders.
  bool by_pairs() const { return shape == Columns::pairs || shape == Columns::lower_pairs; }

  /// The places of all its columns, for trees whose largest order is K; one place (0, 0) where it has one
  /// column.
  std::vector<OrderPlace> places(std::size_t largest_order) const;
};

/// A column of a table: a statistic, and the place of those that have several. It becomes a name where it is
/// printed.
struct StatisticColumn {
  const StatisticInfo* statistic;
  OrderPlace place;

  /// The only column of a statistic, or the one at a place.
  // NOLINTNEXTLINE(google-explicit-constructor): a statistic of one column is that column
  StatisticColumn(const StatisticInfo& info, OrderPlace at = {}) : statistic(&info), place(at) {}

  /// "strahler", "nodes_3", "ramification_2_1"; orders, but no differences of them, are counted from
  /// leaf_order.
  std::string name(std::size_t leaf_order = 0) const;

  StatisticValue value(const TreeMeasures& measures) const { return statistic->value(measures, place); }
  /// Whole or real, as a real number.
  double real_value(const TreeMeasures& measures) const { return as_real(value(measures)); }
  double as_real(StatisticValue value) const {
    if (statistic->real) return value.real;
    return has(value) ? static_cast<double>(value.whole) : std::numeric_limits<double>::quiet_NaN();
  }
  /// The tree has this value.
  bool has(StatisticValue value) const {
    return statistic->real ? value.real == value.real : value.whole != no_whole;
  }

  friend bool operator==(const StatisticColumn&, const StatisticColumn&) = default;
};

}  // namespace ramify
