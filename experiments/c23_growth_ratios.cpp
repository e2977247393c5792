// C23: bifurcation ratios of the growth models of Horsfield and Woldenberg (1986): terminal growth, which is
// the random BST (C33.2), "E R = 3"; segmental growth, which is the uniform tree (C33.3), "E R = 4.0".
//   C23.1  E M_0/E M_1 = 3 for BSTs at every n.                      True: E M_1 = (n+1)/3.
//   C23.2  The next ratio is nu_1/nu_2 = 3.0389...                   Kovchegov, Zaliapin 2017.
//   C23.3  E M_k/E M_(k+1) -> 4, segmental growth.                   True.
//   C23.4  E M_k/E M_(k+1) -> 3, terminal growth.                    False: 3.0438...
//   C23.5 ff.  The same limit of other splits is R(a,b), from a travelling wave (docs/theory/horton-ratio.md)
//          that knows nothing of finite trees; and not 1/E min(X,1-X) or 1/E X (K96 3.2.2).
//   C23.9  Side branches of BSTs are no geometric sequence, as Tokunaga's law has them (1978).
#include <cmath>

#include "at_infinity.hpp"
#include "bi_order_means.hpp"
#include "exact_range.hpp"
#include "law_pictures.hpp"
#include "order_ratio_limit.hpp"
#include <fmt/format.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/order_means.hpp"
#include "ramify/theory/bst_horton_ratio.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"

namespace ramify {
namespace {

constexpr Size largest_grown = 4096;
constexpr const char* of_streams = "streams, ratio of expected counts, leaf order 0";
constexpr const char* growth_source = "K96 5.1.6, C.1.2; Horsfield, Woldenberg 1986";

double horton_ratio(const char* model) {
  return horton_ratio_constant(Model::parse(model)).value().value;
}

double bst_ratio() {
  static const double ratio = horton_ratio("bst");
  return ratio;
}

OrderMeans bst_counts(const Cancellation& cancellation) {
  return build_law(Model::parse("bst"), largest_grown, OrderMeans(largest_grown), cancellation);
}

Basis first_bst_ratio(const Evidence& evidence) {
  const OrderMeans means = bst_counts(evidence.cancellation);
  constexpr double error = 1e-11;
  LargestOf worst;
  for (Size n = 2; n <= largest_grown; ++n) worst.add(means.streams(n)[0] / means.streams(n)[1] - 3, error);
  return worst.basis(EvidenceKind::exact, Standing::proved, largest_grown,
                     fmt::format("exact expected counts at every n from 2 to {}", largest_grown), "");
}

Basis extrapolated_basis(const Extrapolated& limit) {
  return extrapolated(limit.value, limit.bound, largest_grown, counts_at_infinity(largest_grown));
}

Basis second_bst_ratio(const Evidence& evidence) {
  const OrderMeans means = bst_counts(evidence.cancellation);
  return extrapolated_basis(
      at_infinity(largest_grown, [&](Size n) { return means.streams(n)[1] / means.streams(n)[2]; }));
}

/// T_(1,3)^2/(T_(1,2) T_(1,4)).
Basis side_branch_curvature(const Evidence& evidence) {
  constexpr std::size_t highest = 4;
  const BiOrderMeans means = build_law(Model::parse("bst"), largest_grown,
                                       BiOrderMeans(highest, largest_grown), evidence.cancellation);
  return extrapolated_basis(at_infinity(largest_grown, [&](Size n) {
    const double middle = means.tokunaga(n, 3, 1);
    return middle * middle / (means.tokunaga(n, 2, 1) * means.tokunaga(n, 4, 1));
  }));
}

Statement growth_statement(int part, std::string text, std::string formula, double theory) {
  return {fmt::format("C23.{}", part),
          std::move(text),
          growth_source,
          of_streams,
          Relation::equals,
          std::move(formula),
          theory,
          {},
          std::nullopt};
}

Statement first_of_terminal() {
  Statement first = growth_statement(1, "largest |E M_0/E M_1 - 3| is 0, n from 2 on, bst", "0", 0);
  first.rivals = {{"R, 3.0438..., from the first order on", bst_ratio() - 3}, {"4 - 2/n, uniform trees", 1}};
  return first;
}

Statement second_of_terminal() {
  const auto densities = bst_stream_densities(2);
  Statement second = growth_statement(2, "E M_1/E M_2 -> 3.0389..., bst", "(1/3)/(e^4/128 - e^2/8 + 233/384)",
                                      static_cast<double>(densities[0] / densities[1]));
  second.source = "Kovchegov, Zaliapin 2017";
  second.rivals = {{"3, K96 C.1.2", 3}, {"R, 3.0438...", bst_ratio()}};
  return second;
}

Statement limit_of_segmental() {
  Statement limit =
      growth_statement(3, "E M_k/E M_(k+1) -> 4, segmental growth, catalan", "4", horton_ratio("catalan"));
  limit.rivals = {{"2, of nodes", 2}, {"R of BSTs", bst_ratio()}};
  return limit;
}

Statement limit_of_terminal() {
  Statement limit = growth_statement(4, "E M_k/E M_(k+1) -> 3, terminal growth, bst", "3", 3);
  limit.rivals = {{"4, segmental growth", 4}};
  limit.instead = NamedValue{"R, 3.0438...", bst_ratio()};
  return limit;
}

/// Splits of limiting fraction X, with the mean of X and of its smaller side where these are believed in.
ClaimPart limit_of_split(int part, const char* model, std::vector<NamedValue> rivals) {
  const Model split = Model::parse(model);
  Statement statement =
      growth_statement(part, fmt::format("E M_k/E M_(k+1) -> R(a,b), {}", model),
                       "the travelling wave of docs/theory/horton-ratio.md", horton_ratio(model));
  statement.source = "K96 3.2.2 (E S_n against log_(1/EX) n); docs/theory/horton-ratio.md";
  statement.rivals = std::move(rivals);
  statement.rivals.push_back({"R of BSTs", bst_ratio()});
  return part_without_trees(std::move(statement), order_ratio_limit(split, OrderCount::Of::streams));
}

Statement geometric_side_branches() {
  return {"C23.9",
          "T_(1,3)^2/(T_(1,2) T_(1,4)) is 1: side branches of Tokunaga's law T_k = a c^(k-1), bst",
          "Tokunaga 1978",
          "side branches of order i for each stream of order j, leaf order 0; n -> infinity",
          Relation::equals,
          "1",
          1,
          {},
          std::nullopt};
}

/// The ratios of both growth models and of other splits, order by order.
std::vector<NamedPlot> ratios_of_growth(const Evidence& evidence) {
  std::vector<OrderedCounts> series;
  for (const char* model : {"catalan", "beta(1,5)", "aldous(-1)", "beta(0.5,0.5)", "bst", "beta(10,10)"})
    series.push_back(expected_streams(model, horton_ratio(model), evidence.cancellation));
  return {ratio_picture(
      {"C23_stream_ratios", "Stream ratios of growth models and of beta splits", "M_k / M_(k+1)"},
      "expected counts at n = 10^12; dashed: the limit R; segmental growth is catalan, terminal "
      "growth bst",
      series)};
}

}  // namespace

Claim growth_ratio_claim() {
  const auto streams = OrderCount::Of::streams;
  return {
      "C23",
      "E R = 4 of segmental growth, E R = 3 of terminal growth: bifurcation ratios of growth models",
      growth_source,
      {part_without_trees(first_of_terminal(), first_bst_ratio),
       part_without_trees(second_of_terminal(), second_bst_ratio),
       part_without_trees(limit_of_segmental(), order_ratio_limit(Model::parse("catalan"), streams)),
       part_without_trees(limit_of_terminal(), order_ratio_limit(Model::parse("bst"), streams)),
       limit_of_split(5, "aldous(-1)", {{"4, of the uniform tree", 4}}),
       limit_of_split(6, "beta(0.5,0.5)", {{"1/E X", 2}}), limit_of_split(7, "beta(10,10)", {{"1/E X", 2}}),
       limit_of_split(8, "beta(1,5)", {{"1/E X", 6}, {"1/E(1-X)", 1.2}}),
       part_without_trees(geometric_side_branches(), side_branch_curvature)},
      {},
      ratios_of_growth};
}

}  // namespace ramify
