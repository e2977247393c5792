#include <functional>
#include <string>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/second_constructions.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

namespace ramify {
namespace {

constexpr std::size_t n = 50;
constexpr std::uint64_t trees = 40000;

using Builder = std::function<test::LinkedTree(Stream&)>;

struct Construction {
  std::string name;
  std::string model;
  std::string wrong;  // a near model
  Builder build;
};

/// (order, height) of trees built the other way.
test::Tally tally_built(const Builder& build, std::uint64_t seed) {
  test::Tally tally;
  for (std::uint64_t replicate = 0; replicate < trees; ++replicate) {
    Stream stream({seed, 0}, replicate);
    const auto tree = build(stream);
    EXPECT_EQ(tree.nodes.size(), n);
    const auto [order, height] = test::order_and_height(tree);
    ++tally[{order, height}];
  }
  return tally;
}

/// (order, height) of grown trees.
test::Tally tally_grown(const std::string& model, std::uint64_t seed) {
  test::Tally tally;
  std::visit(
      [&](const auto& law) {
        test::grow_and_measure(law, n, trees, seed,
                               [&](const TreeMeasures& m) { ++tally[{m.strahler, m.height}]; });
      },
      Model::parse(model).law());
  return tally;
}

class SecondConstruction : public ::testing::TestWithParam<Construction> {};

TEST_P(SecondConstruction, HasTheLawOfTheSplitTree) {
  const auto& [name, model, wrong, build] = GetParam();
  const auto built = tally_built(build, test::seed_of(name + ", built"));
  EXPECT_TRUE(test::agrees(
      test::two_samples(name + " and " + model, built, tally_grown(model, test::seed_of(name)))));
  EXPECT_TRUE(test::rejected(
      test::two_samples(name + " and " + wrong, built, tally_grown(wrong, test::seed_of(wrong)))));
}

INSTANTIATE_TEST_SUITE_P(
    Models, SecondConstruction,
    ::testing::Values(Construction{"BstByInsertion", "bst", "beta(1.1,1.1)",
                                   [](Stream& s) { return test::bst_by_insertion(n, s); }},
                      Construction{"DstByInsertion", "dst(0.23)", "patricia(0.23)",
                                   [](Stream& s) { return test::dst_by_insertion(n, 0.23, s); }},
                      Construction{"PatriciaOfStrings", "patricia(0.23)", "dst(0.23)",
                                   [](Stream& s) { return test::patricia_of_strings(n, 0.23, s); }},
                      Construction{"PatriciaOfFairStrings", "patricia(0.5)", "dst(0.5)",
                                   [](Stream& s) { return test::patricia_of_strings(n, 0.5, s); }},
                      Construction{"CatalanByRemy", "catalan", "bst",
                                   [](Stream& s) { return test::catalan_by_remy(n, s); }},
                      Construction{"BetaByOrderStatistics", "beta(2,5)", "beta(2,4)",
                                   [](Stream& s) { return test::beta_by_order_statistics(n, 2, 5, s); }},
                      Construction{"BetaMultinomialByInsertion", "beta_multinomial(2,5)", "beta(2,5)",
                                   [](Stream& s) { return test::beta_multinomial_by_insertion(n, 2, 5, s); }},
                      Construction{
                          "WideBetaMultinomialByInsertion", "beta_multinomial(0.3,0.2)", "beta(0.3,0.2)",
                          [](Stream& s) { return test::beta_multinomial_by_insertion(n, 0.3, 0.2, s); }}),
    [](const auto& instance) { return instance.param.name; });

// beta(a,a+1) and beta(a,a) have the same law of unordered splits ((f(x)+f(1-x))/2 coincide): the same law of
// all that does not see sides (theory.md 0), by different variates.
TEST(BetaTrees, OfAAndAPlusOneAreThoseOfAAndAUpToSides) {
  const auto bst = tally_grown("bst", test::seed_of("bst, sides"));
  EXPECT_TRUE(test::agrees(
      test::two_samples("beta(1,2) and bst", tally_grown("beta(1,2)", test::seed_of("beta(1,2)")), bst)));
  EXPECT_TRUE(test::rejected(
      test::two_samples("beta(1,3) and bst", tally_grown("beta(1,3)", test::seed_of("beta(1,3)")), bst)));
  const auto beta = tally_grown("beta(10,10)", test::seed_of("beta(10,10)"));
  EXPECT_TRUE(test::agrees(test::two_samples(
      "beta(10,11) and beta(10,10)", tally_grown("beta(10,11)", test::seed_of("beta(10,11)")), beta)));
}

}  // namespace
}  // namespace ramify
