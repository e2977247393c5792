#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/text/csv_reader.hpp"

namespace ramify {

/// The number of streams of every order of one tree, as it was published.
struct OrderCounts {
  std::uint64_t leaf_order;           ///< order of the first count: 0 or 1
  std::vector<std::uint64_t> counts;  ///< from the leaf order up; they fall, and the last is above 0
  std::vector<double> diameters;      ///< mean of every order, NaN where none; empty without a column
  std::vector<double> lengths;        ///< likewise
  std::vector<std::string> warnings;  ///< one line each, for standard error
};

/// Reads a table `order,count[,diameter][,length][,leaf_order]` (leaf order 1 where it is not said).
///
/// Throws Error with file:line:column for a column it does not know, orders that do not follow each other,
/// counts that are no whole numbers or do not fall, diameters and lengths that are not positive. Warns where
/// the counts cannot be those of streams.
OrderCounts read_order_counts(const CsvData& table);

/// The text is such a table: its header has `order` and `count`.
bool is_order_table(std::string_view text);

}  // namespace ramify
