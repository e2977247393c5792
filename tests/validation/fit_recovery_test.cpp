// Do fits recover what trees were grown from? Of a thousand trees of known parameters: the bias of the
// estimate in its standard deviations, how many 95 % intervals hold the truth, how often the misfit is called
// small.

#include <string>
#include <vector>

#include "recovery.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/fit/count_fit.hpp"
#include "ramify/fit/limiting_ratio.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/sample/grow_blocks.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"

namespace ramify {
namespace {

constexpr std::uint64_t sets = 1000;

/// A family and the truth.
struct Recovery {
  const char* family;
  std::vector<double> truth;
  bool from_tree;
  Size n;
  test::Shortfall shortfall = {};

  std::string name() const {
    return test::case_name(
        fmt::format("{}_{}_{}_{}", from_tree ? "tree" : "counts", family, truth.front(), n));
  }
};

std::vector<FamilyFit> fits_of_trees(const Recovery& of, const Family& family) {
  const TreeBatch batch{family.at(of.truth), of.n, test::seed_of("fit_recovery"), 2, false};
  const auto trees = batch.grown(0, sets, test::uninterrupted);
  const Family* only = &family;
  std::vector<FamilyFit> fits;
  for (TreeFit& tree : fit_trees(trees, std::span(&only, 1), {}, test::uninterrupted))
    fits.push_back(std::move(tree.families.front()));
  return fits;
}

std::vector<ObservedCounts> grown_counts(const Model& model, Size n, std::uint64_t trees) {
  std::vector<ObservedCounts> counts(trees);
  const GrowingJob job{model, n, test::seed_of("fit_recovery"), {orders_and_height, true}, 0, trees};
  grow_blocks({job}, 2, test::uninterrupted, [&](const Block&, const BlockTrees& grown) {
    grown.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      counts[replicate].streams.assign(measures.streams.begin(),
                                       measures.streams.begin() + measures.strahler + 1);
    });
  });
  return counts;
}

std::vector<FamilyFit> fits_of_counts(const Recovery& of, const Family& family) {
  CountFitter fitter(2, test::uninterrupted);
  std::vector<FamilyFit> fits;
  for (const ObservedCounts& tree : grown_counts(family.at(of.truth), of.n, sets))
    fits.push_back(fitter.fit(family, tree));
  return fits;
}

class Recovered : public testing::TestWithParam<Recovery> {};

TEST_P(Recovered, WithinItsErrors) {
  const Recovery& of = GetParam();
  const Family& family = find_family(of.family);
  test::RecoveredNumber recovered(of.truth[0]);
  std::uint64_t converged = 0, small = 0;
  for (const FamilyFit& fit : of.from_tree ? fits_of_trees(of, family) : fits_of_counts(of, family)) {
    recovered.add(fit.parameters.front());
    converged += fit.converged ? 1 : 0;
    small += fit.goodness.p_value <= 0.05 ? 1 : 0;
  }
  const std::string misfit = fmt::format(", misfit_p <= .05 in {:.3f}", static_cast<double>(small) / sets);
  recovered.expect(of.name(), of.shortfall, of.from_tree ? "" : misfit);
  EXPECT_EQ(converged, sets);
}

std::vector<Recovery> cases() {
  std::vector<Recovery> all;
  for (const bool from_tree : {true, false})
    for (const Size n : from_tree ? std::vector<Size>{60, 1000} : std::vector<Size>{579, 100'000}) {
      const bool is_small = n < 1000;
      // Next to a point of symmetry, and where few nodes say little of large parameters.
      const test::Shortfall wide{false, is_small}, biased{from_tree && is_small, false};
      all.push_back({"patricia", {0.23}, from_tree, n});
      all.push_back({"patricia", {0.1}, from_tree, n});
      all.push_back({"patricia", {0.45}, from_tree, n, wide});
      all.push_back({"dst", {0.1}, from_tree, n});
      all.push_back({"dst", {0.3}, from_tree, n});
      all.push_back({"aldous", {0}, from_tree, n, biased});
      all.push_back({"aldous", {-1}, from_tree, n, biased});
      all.push_back({"aldous", {-1.5}, from_tree, n, biased});
      all.push_back({"ford", {0.3}, from_tree, n});
      all.push_back({"ford", {0.5}, from_tree, n});
      if (from_tree) continue;  // no law: simulated, from counts alone
      all.push_back({"ternary", {0.1}, from_tree, n});
      all.push_back({"ternary", {0.2}, from_tree, n});
      all.push_back({"ternary", {0.3}, from_tree, n});
    }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, Recovered, testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param.name(); });

/// Of two shapes counts tell R(a,b) alone. A fit of two parameters and its ratio take some 0.5 s: 200 sets.
class RecoveredRatio : public testing::TestWithParam<Recovery> {};

TEST_P(RecoveredRatio, WithinItsErrors) {
  const Recovery& of = GetParam();
  constexpr std::uint64_t fewer = 200;
  const Family& family = find_family(of.family);
  const Model model = family.at(of.truth);
  test::RecoveredNumber recovered(horton_ratio_constant(model)->value);
  CountFitter fitter(2, test::uninterrupted);
  std::uint64_t without = 0;
  for (const ObservedCounts& tree : grown_counts(model, of.n, fewer)) {
    const FamilyFit fit = fitter.fit(family, tree);
    if (const auto ratio = fit.converged ? limiting_ratio(fit) : std::nullopt)
      recovered.add(*ratio);
    else
      ++without;
  }
  recovered.expect(of.name(), of.shortfall, fmt::format(", {} without a ratio", without));
}

std::vector<Recovery> ratio_cases() {
  std::vector<Recovery> all;
  for (const Size n : {579u, 100'000u})
    for (const auto& shapes : {std::vector<double>{2, 5}, {1, 1}, {0.5, 2}})
      all.push_back({"beta", shapes, false, n, {true, false, 0.7}});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, RecoveredRatio, testing::ValuesIn(ratio_cases()),
                         [](const auto& instance) { return instance.param.name(); });

}  // namespace
}  // namespace ramify
