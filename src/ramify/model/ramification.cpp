#include "ramify/model/ramification.hpp"

#include <numeric>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/model/parameter.hpp"
#include "ramify/random/hash.hpp"

namespace ramify {
namespace {

void require_row(const std::vector<double>& row, std::size_t order, std::string_view name) {
  const std::string problem = fmt::format("{}: row of order {}", name, order);
  require_distribution(problem, row);
  if (row.back() == 0)
    throw Error(problem, fmt::format("p({0},{0}) is 0: no stream of order {0} would ever end", order),
                "give the diagonal a positive probability");
}

/// Internal nodes below and including a node of each order 0, 1, ...
std::vector<double> expected_internal(const RamificationMatrix& matrix) {
  std::vector<double> expected{0};
  for (const auto& row : matrix) {
    const double sides = std::inner_product(row.begin(), row.end() - 1, expected.begin(), 1.0);
    expected.push_back(sides / row.back() + 2 * expected.back());
  }
  return expected;
}

}  // namespace

Ramification::Ramification(const RamificationMatrix& matrix, std::string_view name) {
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

}  // namespace ramify
