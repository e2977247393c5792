#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "ramify/text/remarks.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify::detail {

/// A row of a table of counts, with the fields that messages point at.
struct OrderRow {
  std::uint64_t order, count;
  std::optional<std::uint64_t> leaf_order;
  double diameter, length, area;  ///< NaN where there is none
  std::string_view order_field, count_field, leaf_order_field;
};

/// The rows of every tree of a table, in the order in which the trees begin.
struct OrderRows {
  std::vector<std::pair<std::string_view, std::vector<OrderRow>>> trees;
  Remarks remarks;
};

/// Reads them; rows of totals are left out. Throws Error for missing columns and fields that are no numbers.
OrderRows read_order_rows(const SourceText& source);

}  // namespace ramify::detail
