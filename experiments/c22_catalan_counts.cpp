// C22.5 to C22.8: nodes and streams of equiprobable binary trees, N_k and M_k.
//   C22.5  E M_0/E M_1 = 4 - 2/n at every n: E M_1 = n(n+1)/(2(2n-1)).
//   C22.6  E N_k/E N_(k+1) -> 2: nodes have another ratio than streams, 4 (C23.3).
//   C22.7  The ramification matrix is P(k,j) = 2^-(j+1), j < k, and P(k,k) = 2^-k, which Viennot et al. 1989
//          conjectured and Penaud 1991 proved.
//   C22.8  Tokunaga's numbers are T_k = 2^(k-1).
// The last two are limits of ratios of exact expected counts, c + O(1/n), to 4^-k n of them.
#include <algorithm>
#include <cmath>

#include "at_infinity.hpp"
#include "bi_order_means.hpp"
#include "catalan_counts.hpp"
#include "exact_range.hpp"
#include "order_ratio_limit.hpp"
#include <fmt/format.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/order_means.hpp"

namespace ramify {
namespace {

constexpr Size largest_counted_tree = 4096;
constexpr std::size_t highest_row = 4;

Statement of_counts(int part, std::string text, std::string source, std::string conventions) {
  return {fmt::format("C22.{}", part),
          std::move(text),
          std::move(source),
          std::move(conventions),
          Relation::equals,
          "0",
          0,
          {},
          std::nullopt};
}

Basis first_ratio(const Cancellation& cancellation) {
  const auto means = build_law(Model::parse("catalan"), largest_counted_tree,
                               OrderMeans(largest_counted_tree), cancellation);
  constexpr double error = 1e-11;
  LargestOf worst;
  for (Size n = 2; n <= largest_counted_tree; ++n) {
    const auto streams = means.streams(n);
    worst.add(streams[0] / streams[1] - (4 - 2 / static_cast<double>(n)), error);
  }
  return worst.basis(EvidenceKind::exact, Standing::proved, static_cast<double>(largest_counted_tree),
                     fmt::format("exact expected counts at every n from 2 to {}", largest_counted_tree));
}

BiOrderMeans catalan_bi_orders(const Cancellation& cancellation) {
  return build_law(Model::parse("catalan"), largest_counted_tree,
                   BiOrderMeans(highest_row, largest_counted_tree), cancellation);
}

/// 2^-(low+1), and of two of the order below 2^-k.
double matrix_entry(std::size_t k, std::size_t low) {
  return std::pow(2.0, -static_cast<double>(std::min(low + 1, k)));
}

Basis matrix_rows(const Cancellation& cancellation) {
  const BiOrderMeans means = catalan_bi_orders(cancellation);
  LargestOf worst;
  for (std::size_t k = 1; k <= highest_row; ++k)
    for (std::size_t low = 0; low <= k; ++low) {
      const auto limit =
          at_infinity(largest_counted_tree, [&](Size n) { return means.ramification(n, k, low); });
      worst.add(limit.value - matrix_entry(k, low), limit.bound);
    }
  return worst.basis(EvidenceKind::limit, Standing::extrapolated, static_cast<double>(largest_counted_tree),
                     counts_at_infinity(largest_counted_tree));
}

Basis tokunaga_numbers(const Cancellation& cancellation) {
  const BiOrderMeans means = catalan_bi_orders(cancellation);
  LargestOf worst;
  for (std::size_t high = 1; high <= highest_row; ++high)
    for (std::size_t low = 0; low < high; ++low) {
      const auto limit =
          at_infinity(largest_counted_tree, [&](Size n) { return means.tokunaga(n, high, low); });
      worst.add(limit.value - std::pow(2.0, static_cast<double>(high - low - 1)), limit.bound);
    }
  return worst.basis(EvidenceKind::limit, Standing::extrapolated, static_cast<double>(largest_counted_tree),
                     counts_at_infinity(largest_counted_tree));
}

/// A part of that basis.
ClaimPart part_by(Statement statement, Basis (*basis)(const Cancellation&)) {
  return part_without_trees(std::move(statement),
                            [basis](const Evidence& evidence) { return basis(evidence.cancellation); });
}

Statement node_ratio() {
  Statement statement =
      of_counts(6, "E N_k/E N_(k+1) -> 2, catalan", "K96 B.1.2; docs/theory/horton-ratio.md",
                "nodes of order k, leaf order 0; n -> infinity, then k");
  statement.formula = "2";
  statement.theory = 2;
  statement.rivals = {{"4, of streams", 4}, {"3, of C.1.2 for BSTs", 3}};
  return statement;
}

}  // namespace

std::vector<ClaimPart> catalan_count_parts() {
  Statement first = of_counts(5, "largest |E M_0/E M_1 - (4 - 2/n)| is 0, n from 2 on, catalan", "Moon 1980",
                              "streams, leaf order 0");
  first.rivals = {{"4 - 1/n", 0.5}, {"4, from the first order on", 1}};
  Statement matrix = of_counts(
      7, "largest deviation of the ramification matrix, rows 1 to 4, from 2^-(j+1), 2^-k is 0, catalan",
      "K96 B.1.2; Penaud 1991", "of nodes, leaf order 0; n -> infinity");
  matrix.rivals = {{"all entries of a row alike", 0.5 - 1.0 / (highest_row + 1)},
                   {"leaf order 1, 2^-j", 0.5}};
  Statement tokunaga = of_counts(
      8, "largest |T_(i,j) - 2^(j-i-1)|, j to 4, is 0, catalan", "Tokunaga 1978; docs/theory/horton-ratio.md",
      "side branches of order i for each stream of order j, leaf order 0; n -> infinity");
  tokunaga.rivals = {{"2^(j-i)", std::pow(2.0, highest_row - 1)},
                     {"1, whatever the orders", std::pow(2.0, highest_row - 1) - 1}};
  return {part_by(std::move(first), first_ratio),
          part_without_trees(node_ratio(), order_ratio_limit(Model::parse("catalan"), OrderCount::Of::nodes)),
          part_by(std::move(matrix), matrix_rows), part_by(std::move(tokunaga), tokunaga_numbers)};
}

}  // namespace ramify
