#include "ramify/format/order_counts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/text/known_columns.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

const std::vector<std::string> known_columns{"order", "count", "diameter", "length", "leaf_order"};

std::uint64_t leaf_order_of(const CsvData& table) {
  if (!table.column("leaf_order")) return 1;
  std::optional<std::uint64_t> leaf_order;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto value = table.optional_count(row, "leaf_order");
    if (!value) continue;
    if (*value > 1 || (leaf_order && *leaf_order != *value)) {
      throw error_at(table.where(row, "leaf_order"), fmt::format("leaf_order {}", *value),
                     "the order of the outermost branches is 0 or 1, the same in the whole table",
                     "correct it");
    }
    leaf_order = value;
  }
  return leaf_order.value_or(1);
}

void require_next_order(const CsvData& table, std::size_t row, std::uint64_t expected) {
  const std::uint64_t order = table.count(row, "order");
  if (order == expected) return;
  throw error_at(table.where(row, "order"), fmt::format("order {}", order),
                 fmt::format("order {} comes here: from the leaf order up, none left out", expected),
                 "sort the rows, or set leaf_order");
}

std::vector<std::uint64_t> read_counts(const CsvData& table, std::uint64_t leaf_order) {
  std::vector<std::uint64_t> counts;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    require_next_order(table, row, leaf_order + row);
    const std::uint64_t count = table.count(row, "count");
    if (count == 0 || (!counts.empty() && count >= counts.back())) {
      throw error_at(
          table.where(row, "count"), fmt::format("count {}", count),
          count == 0 ? "an order that is there has a stream" : "streams become fewer with every order",
          "give the number of streams of each order");
    }
    counts.push_back(count);
  }
  if (counts.size() < 2) {
    throw Error(fmt::format("{}: {} order(s)", table.name(), counts.size()),
                "a bifurcation ratio needs two orders", "add rows");
  }
  return counts;
}

/// Counts of streams obey N_k >= 2 N_(k+1) and end with 1; sums near 2 N_1 - 1 are those of links.
std::vector<std::string> warnings_of(const CsvData& table, const std::vector<std::uint64_t>& counts) {
  std::vector<std::string> warnings;
  double sum = 0;
  for (const std::uint64_t count : counts) sum += static_cast<double>(count);
  const double links = 2 * static_cast<double>(counts.front()) - 1;
  if (std::abs(sum - links) <= std::max(1.0, 0.02 * links)) {
    warnings.push_back(fmt::format(
        "{}: the counts sum to {}, about 2*{}-1: these may be links, nodes or Horsfield orders, not streams",
        table.name(), sum, counts.front()));
  }
  for (std::size_t k = 0; k + 1 < counts.size(); ++k) {
    if (counts[k] / 2 >= counts[k + 1]) continue;
    warnings.push_back(
        fmt::format("{}{} after {} cannot be a count of streams: two of one order meet for each of the next",
                    to_prefix(table.where(k + 1)), counts[k + 1], counts[k]));
  }
  if (counts.back() != 1) {
    warnings.push_back(
        fmt::format("{}: {} streams of the highest order: more than one tree, or one cut short", table.name(),
                    counts.back()));
  }
  return warnings;
}

/// A column of positive numbers; empty where there is none.
std::vector<double> read_means(const CsvData& table, std::string_view column) {
  std::vector<double> means;
  if (!table.column(column)) return means;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto mean = table.optional_real(row, column);
    if (mean && *mean <= 0)
      throw error_at(table.where(row, column), fmt::format("{} {}", column, *mean),
                     fmt::format("a {} is positive", column), "correct it, or leave the field empty");
    means.push_back(mean.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return means;
}

}  // namespace

OrderCounts read_order_counts(const CsvData& table) {
  require_known_columns(table, known_columns);
  table.require_column("order");
  table.require_column("count");
  const std::uint64_t leaf_order = leaf_order_of(table);
  OrderCounts counts{leaf_order,
                     read_counts(table, leaf_order),
                     read_means(table, "diameter"),
                     read_means(table, "length"),
                     {}};
  counts.warnings = warnings_of(table, counts.counts);
  return counts;
}

bool is_order_table(std::string_view text) {
  DelimitedRows rows(SourceText(text, ""));
  // Binary files and long lines have no header worth cutting into fields.
  constexpr std::size_t longest_header = 1000;
  LineCursor lines(text);
  for (;;) {
    if (!lines.next()) return false;
    if (!lines.line().empty() && !lines.line().starts_with('#')) break;
  }
  if (lines.line().size() > longest_header || lines.line().find('"') != std::string_view::npos) return false;
  if (!rows.next()) return false;
  const auto has = [&](std::string_view name) {
    return std::ranges::find(rows.fields(), name) != rows.fields().end();
  };
  return has("order") && has("count");
}

}  // namespace ramify
