// H2, Fact 3.4 as a recipe (Kruszewski 1996, 3.1.5, 3.2.2, 3.3, 5.1.6): to model a species of bifurcation
// ratio R, grow a PATRICIA tree with p = 1/R.
//
// Of a fixed order the ratio of streams is not 1/p: E M_0/E M_1 -> h/(pq), h the entropy of p, and only as
// the order grows the ratios go to 1/p, slowly. What a tree of the thesis' sizes then has is known by its
// law: the mean of the ratio that is regressed on all orders, and how it scatters from tree to tree. The
// apple, 4.35 of 579 branches, is out of reach of p = 1/4.35; the lung, 2.74, comes out because h/(pq)
// is 2.83 there. Of the ternary trees of white fir and sugar maple: h02_ternary.cpp.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "law_pictures.hpp"
#include "ternary_recipe.hpp"
#include <fmt/format.h>

#include "ramify/compare/interval.hpp"
#include "ramify/estimate/limit_slope.hpp"
#include "ramify/fit/law_ratios.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/theory/bst_horton_ratio.hpp"
#include "ramify/theory/depth_constant.hpp"

namespace ramify {
namespace {

Model patricia_of_ratio(double ratio) {
  return Model::parse(fmt::format("patricia(1/{})", ratio));
}

/// h/(pq).
double first_stream_ratio(const Model& patricia) {
  const double p = patricia.parameters().front();
  return 1 / (p * (1 - p) * depth_constant(patricia).value().value);
}

/// E M_0 / E M_1 at sizes over 21 decades: where they lie, and as much on either side.
Basis first_ratio_limit(const Model& patricia, const Cancellation& cancellation) {
  constexpr double smallest = 1e9, largest = 1e30, factor = 1e3;
  std::vector<double> sizes;
  for (double n = smallest; n < 2 * largest; n *= factor) sizes.push_back(n);
  const LargeOrders orders(patricia, sizes, cancellation);
  double least = HUGE_VAL, most = 0, error = 0;
  for (const double n : sizes) {
    const auto means = orders.means(n, OrderCount::Of::streams);
    const double ratio = means[0].value / means[1].value;
    least = std::min(least, ratio);
    most = std::max(most, ratio);
    error = std::max(error, ratio * (means[0].error / means[0].value + means[1].error / means[1].value));
  }
  const double bound = most - least + error;
  return {EvidenceKind::limit,
          Standing::extrapolated,
          (least + most) / 2,
          {least - bound, most + bound},
          largest,
          fmt::format(
              "E M_0/E M_1 at n = {:g}, {:g}, ..., {:g}; bound: their range once more on either side, and "
              "the errors of the laws",
              smallest, smallest * factor, largest),
          "larger sizes"};
}

/// lim E M_(k-1)/E M_k as k grows, of trees so large that the order k is far from the root.
Basis late_ratio_limit(const Model& patricia, const Cancellation& cancellation) {
  constexpr double n = 1e60;
  constexpr std::size_t first = 8, last = 40;
  const LargeOrders orders(patricia, {n}, cancellation);
  const auto means = orders.means(n, OrderCount::Of::streams);
  std::vector<KnownPoint> points;
  for (std::size_t k = first; k <= last; k += 2)
    points.push_back(
        {static_cast<double>(k), std::log(n) - std::log(means[k].value), means[k].error / means[k].value});
  const LimitSlope slope = drifting_slope(points);
  return {
      EvidenceKind::limit,
      Standing::extrapolated,
      std::exp(slope.value),
      {std::exp(slope.value - slope.bound), std::exp(slope.value + slope.bound)},
      n,
      fmt::format("slope of log(n/E M_k) on k, k = {}..{}, n = {:g}: with terms log k and powers of k^(-1/2) "
                  "fitted; bound: thrice the change from one and two terms fewer, and the errors of the laws",
                  first, last, n),
      "larger orders"};
}

/// The ratio of one tree of n nodes, in 99 of 100: the range that its law leaves it.
Basis ratio_of_one_tree(const Model& patricia, Size n, const Cancellation& cancellation) {
  constexpr auto estimator = LawEstimator::streams_regression_of_means;
  const StreamCounts counts = stream_counts(patricia, n, cancellation);
  const double ratio = law_ratio(estimator, counts), deviation = law_ratio_deviation(estimator, counts);
  const double scatter = simultaneous_sigmas(0.01, 1) * deviation;
  return {EvidenceKind::exact,
          Standing::extrapolated,
          ratio,
          {ratio - scatter, ratio + scatter},
          static_cast<double>(n),
          fmt::format(
              "ratio regressed on all orders of the expected counts of streams, by their law; range: 99 of "
              "100 trees, whose standard deviation is {:.3g} by the delta method",
              deviation),
          fmt::format("trees of more than {} nodes", n)};
}

Statement claimed_first_ratio(std::size_t number, double ratio) {
  const Model patricia = patricia_of_ratio(ratio);
  return {fmt::format("H2.{}", number),
          fmt::format("E M_0/E M_1 -> 1/p, {}", patricia.text()),
          "K96 Fact 3.4 as a recipe, 3.1.5",
          "streams, leaf order 0",
          Relation::equals,
          "1/p",
          ratio,
          {{"BST", bst_horton_ratio().value}, {"4, uniform trees", 4}},
          NamedValue{"h/(pq)", first_stream_ratio(patricia)}};
}

Statement claimed_late_ratio(std::size_t number, double ratio) {
  const Model patricia = patricia_of_ratio(ratio);
  return {fmt::format("H2.{}", number),
          fmt::format("lim E M_(k-1)/E M_k -> 1/p as k grows, {}", patricia.text()),
          "K96 Fact 3.4 as a recipe, 3.1.5",
          "streams, leaf order 0; n to infinity first",
          Relation::equals,
          "1/p",
          ratio,
          {{"h/(pq), the first ratio", first_stream_ratio(patricia)}, {"BST", bst_horton_ratio().value}},
          std::nullopt};
}

Statement ratio_of_recipe(std::size_t number, const char* species, double ratio, Size n) {
  return {fmt::format("H2.{}", number),
          fmt::format("a tree of {} nodes, {}, has the ratio {} of {}, in 99 of 100", n,
                      patricia_of_ratio(ratio).text(), ratio, species),
          "K96 3.2.2, 3.3, 5.1.6",
          "streams, regression of log counts on all orders",
          Relation::equals,
          fmt::format("{}, measured", ratio),
          ratio,
          {{"BST", bst_horton_ratio().value}, {"4, uniform trees", 4}},
          std::nullopt};
}

/// The ratio goes from h/(pq) to 1/p as the order grows; a tree of the apple's size has the low orders alone.
std::vector<NamedPlot> ratios_of_recipes(const Evidence& evidence) {
  constexpr Size apple = 579;
  constexpr const char *of_apple = "patricia(1/4.35)", *of_lung = "patricia(1/2.74)";
  const double apple_ratio = 1 / Model::parse(of_apple).parameters().front(),
               lung_ratio = 1 / Model::parse(of_lung).parameters().front();
  auto small = stream_counts(Model::parse(of_apple), apple, evidence.cancellation).means;
  std::erase_if(small, [](double mean) { return mean < 1; });
  return {ratio_picture({"H2_recipe", "PATRICIA trees of p = 1/R: their stream ratios", "M_k / M_(k+1)"},
                        "expected counts at n = 10^12; dashed: R = 1/p",
                        {expected_streams(of_apple, apple_ratio, evidence.cancellation),
                         expected_streams(of_lung, lung_ratio, evidence.cancellation),
                         {"patricia(1/4.35), n = 579", std::move(small)}}),
          ternary_recipe_picture(evidence.cancellation)};
}

struct RecipeCase {
  const char* species;
  double ratio;
  Size n;
};

}  // namespace

Claim recipe_claim() {
  constexpr double apple = 4.35, lung = 2.74;
  std::vector<ClaimPart> parts;
  for (const double ratio : {apple, lung})
    parts.push_back(
        part_without_trees(claimed_first_ratio(parts.size() + 1, ratio), [ratio](const Evidence& evidence) {
          return first_ratio_limit(patricia_of_ratio(ratio), evidence.cancellation);
        }));
  parts.push_back(
      part_without_trees(claimed_late_ratio(parts.size() + 1, apple), [](const Evidence& evidence) {
        return late_ratio_limit(patricia_of_ratio(apple), evidence.cancellation);
      }));
  for (const auto& [species, ratio, n] :
       {RecipeCase{"the apple", apple, 579}, RecipeCase{"the bronchial tree", lung, 1000}})
    parts.push_back(part_without_trees(
        ratio_of_recipe(parts.size() + 1, species, ratio, n), [ratio, n](const Evidence& evidence) {
          return ratio_of_one_tree(patricia_of_ratio(ratio), n, evidence.cancellation);
        }));
  std::ranges::move(ternary_recipe_parts(parts.size() + 1), std::back_inserter(parts));
  return {"H2",
          "p = 1/R: a PATRICIA tree of p = 1/R has the bifurcation ratio R",
          "K96 3.1.5, 3.2.2",
          std::move(parts),
          {},
          ratios_of_recipes};
}

}  // namespace ramify
