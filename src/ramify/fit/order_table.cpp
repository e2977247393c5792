#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "ramify/fit/ratio_table.hpp"
#include "ramify/statistic/order_ratios.hpp"
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

std::vector<std::uint64_t> read_counts(const CsvData& table) {
  const std::uint64_t leaf_order = leaf_order_of(table);
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

/// exp of the unweighted least-squares slope of log diameter on order (Horton's law of diameters), where two
/// orders have one and it is above 1.
std::optional<PrintedRatio> diameter_ratio_of(const CsvData& table) {
  if (!table.column("diameter")) return std::nullopt;
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto diameter = table.optional_real(row, "diameter");
    if (!diameter) continue;
    if (*diameter <= 0)
      throw error_at(table.where(row, "diameter"), fmt::format("diameter {}", *diameter),
                     "a diameter is positive", "correct it, or leave the field empty");
    const double order = static_cast<double>(row), logarithm = std::log(*diameter);
    count += 1;
    x += order;
    y += logarithm;
    xx += order * order;
    xy += order * logarithm;
  }
  if (count < 2) return std::nullopt;
  const double ratio = std::exp((count * xy - x * y) / (count * xx - x * x));
  return ratio > 1 ? std::optional(PrintedRatio{ratio, 0}) : std::nullopt;
}

}  // namespace

RatioDatum parse_order_table(const CsvData& table) {
  require_known_columns(table, known_columns);
  table.require_column("order");
  table.require_column("count");
  const std::vector<std::uint64_t> counts = read_counts(table);
  const OrderRatios ratios = order_ratios(counts);
  RatioDatum datum;
  datum.name = std::filesystem::path(table.name()).stem().string();
  datum.where = {table.name(), 0, 0};
  datum.ratio = ratios.mean_ratio;
  datum.observed[index_of(RatioEstimator::streams_mean_ratio)] = ratios.mean_ratio;
  datum.observed[index_of(RatioEstimator::streams_regression)] = ratios.regression;
  datum.observed[index_of(RatioEstimator::streams_geometric)] = ratios.geometric;
  datum.branching = {ratios.regression, 0};
  datum.diameter_ratio = diameter_ratio_of(table);
  datum.sizes = {{counts.front() - 1, "counted", ""}};
  datum.warnings = warnings_of(table, counts);
  if (!(datum.ratio > 2)) {
    throw error_at(datum.where, fmt::format("mean ratio {}", datum.ratio),
                   "a stream of order k+1 begins where two of order k meet, so a ratio is above 2",
                   "give the number of streams of each order");
  }
  return datum;
}

}  // namespace ramify
