#include "ramify/model/split_table.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include <fmt/format.h>

#include "ramify/core/compensated_sum.hpp"
#include "ramify/core/number.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

constexpr double largest_miss = 1e-9;  // of a sum of probabilities that were printed with 10 digits

/// A probability and the row of the file that it is from.
struct Placed {
  SplitProbability value;
  std::size_t row;
};

Placed read_row(const CsvData& csv, std::size_t row) {
  const SplitProbability read{csv.count(row, "n"), csv.count(row, "left"), csv.real(row, "probability")};
  if (read.n == 0)
    throw error_at(csv.where(row, "n"), "n = 0", "an external node has no split", "start at n = 1");
  if (read.left >= read.n)
    throw error_at(csv.where(row, "left"), fmt::format("left = {} in a tree of n = {}", read.left, read.n),
                   fmt::format("the root is one of its nodes: left is 0 to {}", read.n - 1),
                   "count the internal nodes of the left subtree");
  if (read.probability < 0)
    throw error_at(csv.where(row, "probability"), fmt::format("probability = {}", read.probability),
                   "a probability is not below 0", "correct it, or leave the row out where it is 0");
  return {read, row};
}

/// Ordered by n, then left, and no pair twice.
std::vector<Placed> read_rows(const CsvData& csv) {
  for (const char* column : {"n", "left", "probability"}) csv.require_column(column);
  std::vector<Placed> rows;
  rows.reserve(csv.rows());
  for (std::size_t row = 0; row < csv.rows(); ++row) rows.push_back(read_row(csv, row));
  if (rows.empty())
    throw error_at({csv.name(), 0, 0}, "no rows", "a split law has a row for each n and left",
                   "add n = 2 at least");
  const auto key = [](const Placed& p) { return std::tuple(p.value.n, p.value.left, p.row); };
  std::sort(rows.begin(), rows.end(), [key](const Placed& a, const Placed& b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto& [n, left, probability] = rows[i].value;
    if (rows[i - 1].value.n == n && rows[i - 1].value.left == left)
      throw error_at(csv.where(rows[i].row, "left"), fmt::format("n = {}, left = {} twice", n, left),
                     fmt::format("line {} has it already", csv.where(rows[i - 1].row).line),
                     "remove one, or add the two up");
  }
  return rows;
}

void require_next_size(const CsvData& csv, const Placed& first, Size previous) {
  if (first.value.n == previous + 1) return;
  throw error_at(csv.where(first.row, "n"),
                 fmt::format("n = {}, and no row of n = {}", first.value.n, previous + 1),
                 "a subtree may have any size below that of its tree",
                 fmt::format("add the rows of n = {}", previous + 1));
}

/// Of the rows of one size.
double require_sum(const CsvData& csv, std::span<const Placed> rows) {
  std::vector<double> probabilities;
  for (const Placed& row : rows) probabilities.push_back(row.value.probability);
  const double sum = compensated_sum(probabilities);
  if (std::abs(sum - 1) <= largest_miss) return sum;
  throw error_at(
      csv.where(rows.front().row),
      fmt::format("the probabilities of n = {} sum to {}", rows.front().value.n, format_summary(sum)),
      "those of every n sum to 1, within 1e-9",
      "correct the rows of this n, and give them 10 digits or more");
}

}  // namespace

std::vector<SplitProbability> read_split_table(const CsvData& csv) {
  const std::vector<Placed> rows = read_rows(csv);
  std::vector<SplitProbability> table;
  table.reserve(rows.size() + 1);
  if (rows.front().value.n > 1) table.push_back({1, 0, 1});
  for (auto begin = rows.begin(); begin != rows.end();) {
    const Size n = begin->value.n;
    const auto end = std::find_if(begin, rows.end(), [n](const Placed& p) { return p.value.n != n; });
    require_next_size(csv, *begin, table.empty() ? 0 : table.back().n);
    const double sum = require_sum(csv, {begin, end});
    for (; begin != end; ++begin)
      if (begin->value.probability > 0)
        table.push_back({n, begin->value.left, begin->value.probability / sum});
  }
  return table;
}

}  // namespace ramify
