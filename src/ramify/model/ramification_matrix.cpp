#include "ramify/model/ramification_matrix.hpp"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/model/parameter.hpp"
#include "ramify/text/csv_reader.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

/// The place of an order in a file, with leaf order 0.
std::uint64_t order_at(const CsvData& table, std::size_t row, std::string_view column,
                       std::uint64_t leaf_order, std::uint64_t least, std::uint64_t most) {
  const std::uint64_t value = table.count(row, column);
  if (value >= leaf_order + least && value <= leaf_order + most) return value - leaf_order;
  throw error_at(table.where(row, column), fmt::format("{} {}", column, value),
                 fmt::format("{} to {} make sense here, with leaf order {}", leaf_order + least,
                             leaf_order + most, leaf_order),
                 "correct it");
}

std::uint64_t leaf_order_at(const CsvData& table, std::size_t row) {
  if (!table.column("leaf_order")) return 1;
  const std::uint64_t leaf_order = table.count(row, "leaf_order");
  if (leaf_order <= 1) return leaf_order;
  throw error_at(table.where(row, "leaf_order"), fmt::format("leaf_order {}", leaf_order), "it is 0 or 1",
                 "correct it");
}

/// The names of three columns.
struct MatrixColumns {
  const char *from, *to, *value;
};

/// Columns as a square table: of the orders 1, 2, ... to 0, ..., most(order), of value(row).
template <class Most, class Value>
RamificationMatrix read_rows(const CsvData& table, const MatrixColumns& columns, Most most, Value value) {
  for (const char* column : {columns.from, columns.to, columns.value}) table.require_column(column);
  RamificationMatrix rows;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::uint64_t leaf_order = leaf_order_at(table, row);
    const std::uint64_t order = order_at(table, row, columns.from, leaf_order, 1, most_orders);
    const std::uint64_t other = order_at(table, row, columns.to, leaf_order, 0, most(order));
    while (rows.size() < order) rows.emplace_back(most(rows.size() + 1) + 1, 0.0);
    double& place = rows[order - 1][other];
    if (place != 0)
      throw error_at(table.where(row), fmt::format("p({},{}) again", order + leaf_order, other + leaf_order),
                     "another line has it too", "leave one of them out");
    place = value(row);
  }
  if (rows.empty())
    throw Error(fmt::format("{}: no rows", table.name()), "a matrix has one at least", "add them");
  return rows;
}

/// The most that the side of an order is, in a ramification matrix.
std::uint64_t to_itself(std::uint64_t order) {
  return order;
}

}  // namespace

RamificationMatrix read_ramification_matrix(const std::filesystem::path& path) {
  const CsvData table = CsvData::read(path);
  return read_rows(table, {"order", "side", "probability"}, to_itself,
                   [&table](std::size_t row) { return table.real(row, "probability"); });
}

RamificationMatrix read_bi_order_counts(const CsvData& table) {
  return read_rows(table, {"order", "side", "count"}, to_itself,
                   [&table](std::size_t row) { return static_cast<double>(table.count(row, "count")); });
}

RamificationMatrix read_markov_chain(const std::filesystem::path& path) {
  const CsvData table = CsvData::read(path);
  auto rows = read_rows(
      table, {"state", "next", "probability"}, [](std::uint64_t) { return most_orders; },
      [&table](std::size_t row) { return table.real(row, "probability"); });
  for (std::size_t k = 1; k <= rows.size(); ++k) {
    auto& row = rows[k - 1];
    const std::string problem = fmt::format("{}: transitions of state {} (leaf order 0)", table.name(), k);
    require_distribution(problem, row);
    row.resize(k + 1);
    const double kept = std::accumulate(row.begin(), row.end(), 0.0);
    if (!(kept > 0))
      throw Error(problem, "none leads to itself or to a lower state, so no node of that order has children",
                  "number the states so that every one leads down");
    for (double& p : row) p /= kept;
  }
  return rows;
}

RamificationMatrix tokunaga_matrix(double a, double c) {
  RAMIFY_EXPECTS(a > 0 && c > 0);
  RamificationMatrix matrix;
  std::vector<double> sides;  // T_k, ..., T_1
  double total = 1;
  for (std::size_t k = 1; k <= most_orders; ++k) {
    const double t = a * std::pow(c, static_cast<double>(k - 1));
    total += t;
    if (!std::isfinite(total)) break;
    sides.insert(sides.begin(), t);
    auto& row = matrix.emplace_back(sides);
    row.push_back(1);
    for (double& p : row) p /= total;
  }
  return matrix;
}

RamificationMatrix hybrid_matrix(const RamificationMatrix& first, const RamificationMatrix& second,
                                 std::string_view pattern) {
  RamificationMatrix hybrid;
  for (const char letter : pattern) {
    const std::string problem = fmt::format("hybrid(A,B,{})", pattern);
    if (letter != 'A' && letter != 'B')
      throw Error(problem, fmt::format("'{}' is neither A nor B", letter),
                  "write one letter for every row, the lowest order first, such as AAB");
    const RamificationMatrix& source = letter == 'A' ? first : second;
    if (hybrid.size() >= source.size())
      throw Error(problem, fmt::format("matrix {} has {} rows", letter, source.size()),
                  "shorten the pattern, or add rows to the file");
    hybrid.push_back(source[hybrid.size()]);
  }
  if (hybrid.empty())
    throw Error("hybrid(A,B,)", "it has no row", "write one letter for every row, such as AAB");
  return hybrid;
}

}  // namespace ramify
