// Simpler families within larger ones, and whether they suffice.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/fit/nested_test.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify {
namespace {

const Cancellation ignored;

/// How far two split laws are from each other at n, where left and right mean nothing.
double unordered_distance(const Model& one, const Model& other, Size n) {
  const auto p = split_pmf(one, n), q = split_pmf(other, n);
  double distance = 0;
  for (Size i = 0; i < n; ++i)
    distance = std::max(distance, std::abs(p[i] + p[n - 1 - i] - q[i] - q[n - 1 - i]));
  return distance;
}

constexpr Size largest = 60;

/// The largest over all sizes.
double unordered_distance(const Model& one, const Model& other) {
  double distance = 0;
  for (Size n = 1; n <= largest; ++n) distance = std::max(distance, unordered_distance(one, other, n));
  return distance;
}

TEST(NestedFamilies, AreTheLargerOneAtTheirPlace) {
  std::size_t pairs = 0;
  for (const Family& larger : families())
    for (const NestedFamily& nested : larger.nested) {
      const Family& simpler = find_family(nested.name);
      EXPECT_TRUE(simpler.parameters.empty()) << nested.name;
      EXPECT_LT(unordered_distance(simpler.at({}), larger.at(nested.values)), 1e-12)
          << nested.name << " in " << larger.name;
      ++pairs;
    }
  EXPECT_GE(pairs, 7u);
}

/// Split fractions of aldous tend to beta(b+1,b+1), and no more than that: neither is nested in the other.
TEST(NestedFamilies, AreNotThoseThatOnlyTendToIt) {
  for (const char* name : {"beta(2,2)", "beta_multinomial(2,2)"})
    EXPECT_GT(unordered_distance(Model::parse("aldous(1)"), Model::parse(name)), 1e-3) << name;
}

/// What `fit` says of two shapes that cannot be told apart.
TEST(NestedFamilies, ShapesThatDifferByOneAreAlikeAndByTwoAreNot) {
  for (const std::string name : {"beta", "beta_multinomial"}) {
    const Model even = Model::parse(name + "(1.7,1.7)");
    EXPECT_LT(unordered_distance(even, Model::parse(name + "(1.7,2.7)")), 1e-12) << name;
    EXPECT_GT(unordered_distance(even, Model::parse(name + "(1.7,3.7)")), 1e-3) << name;
  }
}

std::vector<FamilyFit> fits_of(std::initializer_list<const char*> names, const ObservedSplits& splits) {
  std::vector<FamilyFit> fits;
  for (const char* name : names)
    fits.push_back(fit_family(find_family(name), tree_objective(find_family(name), splits), splits.nodes()));
  return fits;
}

ObservedSplits splits_of(const char* model, Size n, std::uint64_t replicate) {
  const TreeBatch batch{Model::parse(model), n, test::seed_of("fit nested"), 1, false};
  return {batch.grown(replicate, replicate + 1, ignored)[0].tree, "t"};
}

TEST(NestedTest, IsMadeOfNestedFamiliesAlone) {
  std::vector<FamilyFit> fits =
      fits_of({"patricia", "ford", "bst", "aldous", "dst"}, splits_of("bst", 200, 0));
  const auto pairs = nested_pairs(fits);
  ASSERT_EQ(pairs.size(), 2u);
  for (const NestedPair& pair : pairs) EXPECT_EQ(pair.simpler->family->name, "bst");
  EXPECT_EQ(pairs[0].larger->family->name, "ford");
  EXPECT_EQ(pairs[1].larger->family->name, "aldous");
}

TEST(NestedTest, ThePValueIsTheRankAmongGrownTrees) {
  std::vector<FamilyFit> fits = fits_of({"bst", "aldous"}, splits_of("bst", 200, 0));
  fits[0].log_likelihood = -10;
  fits[1].log_likelihood = -8;
  add_nested_test(nested_pairs(fits)[0], std::vector<double>{1, 5, 4, 0});
  ASSERT_EQ(fits[1].simpler.size(), 1u);
  EXPECT_DOUBLE_EQ(fits[1].simpler[0].likelihood_ratio, 4);
  EXPECT_DOUBLE_EQ(fits[1].simpler[0].p_value, 3.0 / 5);
  EXPECT_EQ(fits[1].simpler[0].trees, 4u);
}

TEST(NestedTest, RejectsWhatIsNotEnoughAndKeepsWhatIs) {
  const std::vector<const Family*> chosen{&find_family("aldous"), &find_family("bst"),
                                          &find_family("catalan")};
  const TreeBatch batch{Model::parse("bst"), 300, test::seed_of("fit nested"), 1, false};
  const auto fit = fit_trees(batch.grown(2, 3, ignored), chosen, {false, {99, 5}, 2}, ignored)[0];
  const auto aldous =
      std::ranges::find(fit.families, "aldous", [](const FamilyFit& of) { return of.family->name; });
  ASSERT_EQ(aldous->simpler.size(), 2u);
  for (const NestedTest& test : aldous->simpler) {
    const bool is_bst = test.simpler->name == "bst";
    EXPECT_EQ(test.trees, 99u);
    EXPECT_EQ(test.p_value > 0.02, is_bst) << test.simpler->name << ' ' << test.p_value;
  }
}

}  // namespace
}  // namespace ramify
