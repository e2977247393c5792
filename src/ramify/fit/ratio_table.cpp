#include "ramify/fit/ratio_table.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ramify/text/known_columns.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

const std::vector<std::string> known_columns{"name",
                                             "latin",
                                             "ratio",
                                             "leaf_order",
                                             "max_order_low",
                                             "max_order_high",
                                             "branches",
                                             "portion",
                                             "diameter_ratio",
                                             "length_ratio",
                                             "order1_diameter_mm",
                                             "order1_length_mm",
                                             "root_diameter_mm",
                                             "root_length_mm",
                                             "citation",
                                             "confidence",
                                             "note"};

constexpr std::uint64_t largest_printed_order = 61;

bool has(const CsvData& table, std::size_t row, std::string_view column) {
  return table.column(column) && !table.at(row, column).empty();
}

std::optional<std::uint64_t> count_at(const CsvData& table, std::size_t row, std::string_view column,
                                      std::uint64_t least, std::uint64_t most) {
  if (!table.column(column)) return std::nullopt;
  const auto value = table.optional_count(row, column);
  if (value && (*value < least || *value > most)) {
    throw error_at(table.where(row, column), fmt::format("{} {}", column, *value),
                   fmt::format("{} to {} make sense", least, most), "correct it, or leave the field empty");
  }
  return value;
}

/// A ratio above a bound, with half a unit of its last digit.
PrintedRatio ratio_at(const CsvData& table, std::size_t row, std::string_view column, double bound,
                      std::string_view why) {
  const double value = table.real(row, column);
  if (!(value > bound))
    throw error_at(table.where(row, column), fmt::format("{} {}", column, value), why, "correct it");
  const std::string text = table.text(row, column);
  const auto point = text.find('.');
  const bool plain = text.find_first_of("eE/") == std::string::npos;
  const double digits = point == std::string::npos ? 0 : static_cast<double>(text.size() - point - 1);
  return {value, plain ? 0.5 * std::pow(10.0, -digits) : 0};
}

void require_leaf_order(const CsvData& table, std::size_t row) {
  count_at(table, row, "leaf_order", 0, 1);
}

/// Of the portion that is to be modelled, if one is named, and of the whole tree.
std::vector<SizeChoice> sizes_at(const CsvData& table, std::size_t row, double ratio) {
  std::vector<SizeChoice> sizes;
  if (const auto n = count_at(table, row, "portion", 2, max_size))
    sizes.push_back({*n, "portion", "a part of a larger tree"});
  if (const auto n = count_at(table, row, "branches", 2, max_size)) {
    sizes.push_back({*n, "printed", ""});
    return sizes;
  }
  const auto low = count_at(table, row, "max_order_low", 2, largest_printed_order);
  const auto high = count_at(table, row, "max_order_high", 2, largest_printed_order);
  if (low && high && *low > *high) {
    throw error_at(table.where(row, "max_order_high"), fmt::format("max_order_high {}", *high),
                   fmt::format("it is below max_order_low {}", *low), "exchange them");
  }
  for (const auto& order : {low, low == high ? std::nullopt : high})
    if (order)
      sizes.push_back({whole_horton_size(ratio, *order), "horton",
                       fmt::format("n = (R^{0} - 1)/(R - 1), order {0}", *order)});
  return sizes;
}

RatioDatum datum_at(const CsvData& table, std::size_t row) {
  RatioDatum datum;
  datum.name = table.text(row, "name");
  datum.where = table.where(row);
  datum.branching = ratio_at(table, row, "ratio", 2,
                             "a stream of order k+1 begins where two of order k meet, so a ratio is above 2");
  datum.ratio = datum.branching.value;
  datum.observed.fill(datum.ratio);
  datum.observed_by_law.fill(datum.ratio);
  require_leaf_order(table, row);
  datum.sizes = sizes_at(table, row, datum.ratio);
  if (has(table, row, "diameter_ratio"))
    datum.diameter_ratio =
        ratio_at(table, row, "diameter_ratio", 1, "branches grow thicker with their order");
  if (has(table, row, "length_ratio"))
    ratio_at(table, row, "length_ratio", 0, "a ratio of lengths is positive");
  if (has(table, row, "citation")) datum.citation = table.text(row, "citation");
  if (has(table, row, "confidence")) datum.confidence = table.text(row, "confidence");
  return datum;
}

void refuse_second_name(const std::vector<RatioDatum>& data, const RatioDatum& datum) {
  for (const RatioDatum& earlier : data) {
    if (earlier.name != datum.name) continue;
    throw error_at(
        datum.where, fmt::format("name '{}' again", datum.name),
        fmt::format("line {} has it too, and rows of the result are told apart by it", earlier.where.line),
        "give each row its own name");
  }
}

}  // namespace

std::vector<RatioDatum> parse_ratio_table(const CsvData& table) {
  require_known_columns(table, known_columns);
  table.require_column("name");
  table.require_column("ratio");
  std::vector<RatioDatum> data;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    RatioDatum datum = datum_at(table, row);
    refuse_second_name(data, datum);
    data.push_back(std::move(datum));
  }
  if (data.empty())
    throw Error(fmt::format("{}: no rows", table.name()), "there is nothing to fit", "add one");
  return data;
}

}  // namespace ramify
