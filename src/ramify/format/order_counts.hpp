#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/error.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify {

/// The number of streams of every order of one tree, as it was published.
struct OrderCounts {
  std::string name;                   ///< the file, and the tree where a column names several
  std::uint64_t leaf_order;           ///< order of the first count: 0 or 1
  std::vector<std::uint64_t> counts;  ///< from the leaf order up; they fall, and the last is above 0
  std::vector<double> diameters;      ///< mean of every order, NaN where none; empty without a column
  std::vector<double> lengths;        ///< likewise
  std::vector<double> areas;          ///< of drainage, likewise
  std::vector<std::string>
      warnings;  ///< one line each, for standard error; what is ignored with the first tree
  /// Why no binary tree has these streams, with the place: an order has more than half as many as the one
  /// below. A description may stand with the warning, a fit of binary trees may not.
  std::optional<Error> contradiction;
};

/// A binary tree can have so many streams of an order and of the next: two meet for each of the next.
constexpr bool can_follow(std::uint64_t streams, std::uint64_t of_next_order) {
  return streams / 2 >= of_next_order;
}

/// Reads a table of orders and counts, with diameter or radius, length, area, leaf_order (1 where it is not
/// said) and tree where it has such columns, by their usual names (table_columns.hpp) and with any separator
/// (delimited_rows.hpp): `order,count`, "Order;Number;Length (km)", the table that `ramify measure` writes.
/// Rows may come in any order; a row of totals is left out.
///
/// Throws Error with file:line:column for missing columns, orders that do not follow each other, counts that
/// are no whole numbers, can be read two ways ("1.234") or do not fall, diameters, lengths and areas that are
/// not positive. Warns where the counts cannot be those of streams, a total is not the sum, or a column is
/// not read.
std::vector<OrderCounts> read_order_counts(SourceText source);

/// The text is such a table: its header has orders and counts, and is not that of a tree.
bool is_order_table(std::string_view text);

}  // namespace ramify
