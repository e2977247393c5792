#include "ramify/model/ramification.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/model/parameter.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/text/csv_reader.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

constexpr std::size_t most_orders = 62;

void require_row(const std::vector<double>& row, std::size_t order, std::string_view name) {
  const std::string problem = fmt::format("{}: row of order {}", name, order);
  const double sum = std::accumulate(row.begin(), row.end(), 0.0);
  if (std::any_of(row.begin(), row.end(), [](double p) { return !(p >= 0); }))
    throw Error(problem, "a probability is negative", "correct it");
  if (!(std::abs(sum - 1) <= 1e-9))
    throw Error(problem, fmt::format("its probabilities sum to {}, {} off 1", sum, sum - 1),
                "correct one of them");
  if (row.back() == 0)
    throw Error(problem, fmt::format("p({0},{0}) is 0: no stream of order {0} would ever end", order),
                "give the diagonal a positive probability");
}

/// Internal nodes below and including a node of each order 0, 1, ...
std::vector<double> expected_internal(const std::vector<std::vector<double>>& matrix) {
  std::vector<double> expected{0};
  for (const auto& row : matrix) {
    const double sides = std::inner_product(row.begin(), row.end() - 1, expected.begin(), 1.0);
    expected.push_back(sides / row.back() + 2 * expected.back());
  }
  return expected;
}

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

}  // namespace

Ramification::Ramification(const std::vector<std::vector<double>>& matrix, std::string_view name) {
  auto filled = std::make_shared<Matrix>();
  for (std::size_t k = 1; k <= matrix.size(); ++k) {
    const auto& row = matrix[k - 1];
    require_row(row, k, name);
    build_alias_cells(row, filled->rows.emplace_back(row.size()));
    for (const double p : row) filled->hash = hash_text(format_exact(p) + ",", filled->hash);
  }
  for (const double internal : expected_internal(matrix)) filled->expected_nodes.push_back(2 * internal + 1);
  matrix_ = std::move(filled);
}

Ramification Ramification::read(const std::filesystem::path& path) {
  const CsvData table = CsvData::read(path);
  for (const char* column : {"order", "side", "probability"}) table.require_column(column);
  std::vector<std::vector<double>> matrix;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::uint64_t leaf_order = leaf_order_at(table, row);
    const std::uint64_t order = order_at(table, row, "order", leaf_order, 1, most_orders);
    const std::uint64_t side = order_at(table, row, "side", leaf_order, 0, order);
    while (matrix.size() < order) matrix.emplace_back(matrix.size() + 2, 0.0);
    double& place = matrix[order - 1][side];
    if (place != 0)
      throw error_at(table.where(row), fmt::format("p({},{}) again", order + leaf_order, side + leaf_order),
                     "another line has it too", "leave one of them out");
    place = table.real(row, "probability");
  }
  if (matrix.empty())
    throw Error(fmt::format("{}: no rows", table.name()), "a matrix has one at least", "add them");
  return Ramification(matrix, table.name());
}

Ramification Ramification::tokunaga(double a, double c) {
  require_positive("tokunaga(a,c)", "a", a);
  require_positive("tokunaga(a,c)", "c", c);
  std::vector<std::vector<double>> matrix;
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
  return Ramification(matrix, "tokunaga(a,c)");
}

}  // namespace ramify
