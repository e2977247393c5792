#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/statistic/tree_measures.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A value of a statistic: a whole number or a real one, as StatisticInfo::real says.
union StatisticValue {
  std::int64_t whole;
  double real;
};

/// What must be known of a tree for a statistic to be read off.
enum class Measure {
  size,
  strahler,
  height,
  counts,
  depth,
  fill_level,
  balance,
  external_depth,
  shape,      ///< path lengths and indices
  profile,    ///< nodes of every level
  bi_orders,  ///< orders of siblings
};

/// A place in a table by orders: (k, 0) of order k, or (high, low) of two orders.
struct OrderPlace {
  std::size_t high, low;
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

/// What `ramify list statistics` says of a statistic, and how it is read off a measured tree.
struct StatisticInfo {
  std::string_view name;
  std::string_view convention;  ///< base, what is counted
  std::string_view description;
  std::string_view source;
  bool real;        ///< a real number, NaN where a tree has none; else a whole number, summed exactly
  Columns shape;    ///< one column, or one for each order or pair of orders
  Measure measure;  ///< what it is read off
  StatisticValue (*value)(const TreeMeasures&, OrderPlace place);
  bool needs_binary = false;  ///< says nothing of nodes with three children or more
  bool is_order = false;      ///< its value is an order, leaf order 0

  /// "strahler", or "nodes_0..nodes_K".
  std::string columns() const;

  /// One column for each pair of orders.
  bool by_pairs() const { return shape == Columns::pairs || shape == Columns::lower_pairs; }

  /// The name of the column at a place: "strahler", "nodes_3", "ramification_2_1"; orders, but no differences
  /// of them, are counted from leaf_order.
  std::string column_name(OrderPlace place, std::size_t leaf_order = 0) const;

  /// The places of all its columns, for trees whose largest order is K; one place (0, 0) where it has one
  /// column.
  std::vector<OrderPlace> places(std::size_t largest_order) const;
};

/// All statistics, in the order they are listed.
const std::vector<StatisticInfo>& statistics();

/// A choice of statistics, each once, in the order given.
class StatisticSet {
 public:
  /// Throws Error for an unknown name (nearest names given) or one given twice.
  static StatisticSet parse(std::span<const std::string> names);

  const std::vector<const StatisticInfo*>& chosen() const { return chosen_; }
  bool contains(std::string_view name) const;
  /// Nothing but sizes and this is read.
  bool reads_only(Measure measure) const;
  bool reads(Measure measure) const;

  /// A column of a table.
  struct Column {
    std::string name;
    const StatisticInfo* statistic;
    OrderPlace place;
  };

  /// The columns, those by orders up to K, the largest order that a tree of the model and size can have
  /// (Model::largest_order), so that a table's columns never depend on what was drawn.
  std::vector<Column> columns(std::size_t largest_order) const;

 private:
  std::vector<const StatisticInfo*> chosen_;
};

/// The value of a column, whole or real, as a real number.
inline double as_real(const StatisticSet::Column& column, StatisticValue value) {
  return column.statistic->real ? value.real : static_cast<double>(value.whole);
}

/// The statistics of a measured tree, column by column.
void write_statistics(const std::vector<StatisticSet::Column>& columns, const TreeMeasures& measures,
                      std::vector<StatisticValue>& row);

}  // namespace ramify
