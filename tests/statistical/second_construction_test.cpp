// The models by what they are defined by rather than by their split law: every shape of small trees against
// exact shape probabilities, order and height of larger ones against grown trees.

#include <functional>
#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/reference_laws.hpp"
#include "support/sanitized.hpp"
#include "support/second_constructions.hpp"
#include "support/seed.hpp"
#include "support/shape_counts.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify {
namespace {

constexpr std::size_t built_size = 50;
constexpr std::uint64_t built_trees = 70000;

using Builder = std::function<test::LinkedTree(std::size_t n, Stream&)>;

struct Construction {
  std::string name;
  std::string model;
  test::SplitPmf law;
  Builder build;
  std::string wrong;    // a near model
  Builder wrong_build;  // the nearest slip

  friend std::ostream& operator<<(std::ostream& out, const Construction& construction) {
    return out << construction.name;
  }
};

/// (order, height) of trees built the other way.
test::Tally tally_built(const Builder& build, std::uint64_t seed) {
  test::Tally tally;
  for (std::uint64_t replicate = 0; replicate < test::replicates(built_trees); ++replicate) {
    Stream stream({seed, 0}, replicate);
    const auto tree = build(built_size, stream);
    EXPECT_EQ(tree.nodes.size(), built_size);
    const auto [order, height] = test::order_and_height(tree);
    ++tally[{order, height}];
  }
  return tally;
}

/// (order, height) of grown trees.
test::Tally tally_grown(const std::string& model, std::uint64_t seed) {
  test::Tally tally;
  test::grow_and_measure(Model::parse(model), built_size, built_trees, seed,
                         [&](const TreeMeasures& m) { ++tally[{m.strahler, m.height}]; });
  return tally;
}

constexpr std::size_t controlled = 6;  // where the slips are looked for

std::vector<std::uint64_t> count_built(const std::vector<test::Shape>& shapes, std::size_t size,
                                       const Builder& build, const std::string& tag) {
  return test::count_shapes(shapes, size == controlled ? 100000 : 20000, [&](std::uint64_t replicate) {
    Stream stream({test::seed_of(tag), size}, replicate);
    return test::to_word(build(size, stream));
  });
}

class SecondConstruction : public ::testing::TestWithParam<Construction> {};

TEST_P(SecondConstruction, HasTheOrderAndHeightOfTheSplitTree) {
  const auto& [name, model, law, build, wrong, wrong_build] = GetParam();
  const auto built = tally_built(build, test::seed_of(name + ", built"));
  EXPECT_TRUE(test::agrees(
      test::two_samples(name + " and " + model, built, tally_grown(model, test::seed_of(name)))));
  EXPECT_TRUE(test::rejected(
      test::two_samples(name + " and " + wrong, built, tally_grown(wrong, test::seed_of(wrong)))));
}

TEST_P(SecondConstruction, HasTheExactShapeLawToSize7) {
  const auto& construction = GetParam();
  for (std::size_t size = 1; size <= 7; ++size) {
    const auto shapes = test::all_shapes(size);
    const auto law = test::shape_law(shapes, size, construction.law);
    const auto what = fmt::format("{}, shapes of n = {}", construction.name, size);
    EXPECT_TRUE(
        test::agrees(test::chi_square(what, count_built(shapes, size, construction.build, what), law)));
    if (size != controlled) continue;
    const auto slip = what + ", slip";
    EXPECT_TRUE(test::rejected(
        test::chi_square(slip, count_built(shapes, size, construction.wrong_build, slip), law)));
  }
}

Builder bst_by_insertion() {
  return [](std::size_t size, Stream& s) { return test::bst_by_insertion(size, s); };
}
Builder dst_by_insertion(double p) {
  return [p](std::size_t size, Stream& s) { return test::dst_by_insertion(size, p, s); };
}
Builder patricia_of_strings(double p) {
  return [p](std::size_t size, Stream& s) { return test::patricia_of_strings(size, p, s); };
}
Builder patricia_by_insertion(double p) {
  return [p](std::size_t size, Stream& s) { return test::patricia_by_insertion(size, p, s); };
}
Builder order_statistics(std::size_t a, std::size_t b) {
  return [a, b](std::size_t size, Stream& s) { return test::beta_by_order_statistics(size, a, b, s); };
}
Builder urns(double a, double b) {
  return [a, b](std::size_t size, Stream& s) { return test::beta_multinomial_by_insertion(size, a, b, s); };
}
Builder ford_by_growth(double alpha) {
  return [alpha](std::size_t size, Stream& s) { return test::ford_by_growth(size, alpha, s); };
}
test::SplitPmf ford_law(double alpha) {
  return [alpha](Size size) { return test::ford_law(size, alpha); };
}
test::SplitPmf patricia_law(double p) {
  return [p](Size size) { return test::patricia_law(size, p); };
}
test::SplitPmf beta_multinomial_law(double a, double b) {
  return [a, b](Size size) { return test::beta_multinomial_law(size, a, b); };
}

std::vector<Construction> constructions() {
  return {
      {"BstByInsertion", "bst", test::uniform_law, bst_by_insertion(), "beta(1.1,1.1)", urns(1.2, 1.2)},
      {"TerminalGrowth", "bst", test::uniform_law, test::terminal_growth, "catalan", test::segmental_growth},
      {"CatalanByRemy", "catalan", test::catalan_law, test::catalan_by_remy, "bst", bst_by_insertion()},
      {"SegmentalGrowth", "catalan", test::catalan_law, test::segmental_growth, "bst",
       test::stemless_segmental_growth},
      {"FordByGrowth", "ford(0.3)", ford_law(0.3), ford_by_growth(0.3), "ford(0.4)", ford_by_growth(0.5)},
      {"LopsidedFordByGrowth", "ford(0.8)", ford_law(0.8), ford_by_growth(0.8), "ford(0.7)",
       ford_by_growth(0.6)},
      {"DstByInsertion", "dst(0.23)", [](Size size) { return test::dst_law(size, 0.23); },
       dst_by_insertion(0.23), "patricia(0.23)", patricia_of_strings(0.23)},
      {"PatriciaOfStrings", "patricia(0.23)", patricia_law(0.23), patricia_of_strings(0.23), "dst(0.23)",
       dst_by_insertion(0.23)},
      {"PatriciaOfFairStrings", "patricia(0.5)", patricia_law(0.5), patricia_of_strings(0.5), "dst(0.5)",
       dst_by_insertion(0.5)},
      {"PatriciaByInsertion", "patricia(0.23)", patricia_law(0.23), patricia_by_insertion(0.23), "dst(0.23)",
       patricia_by_insertion(0.77)},
      {"PatriciaOfFairStringsByInsertion", "patricia(0.5)", patricia_law(0.5), patricia_by_insertion(0.5),
       "dst(0.5)", patricia_by_insertion(0.45)},
      {"BetaByOrderStatistics", "beta(2,5)", [](Size size) { return test::beta_law(size, 2, 5); },
       order_statistics(2, 5), "beta(2,4)", urns(2, 5)},
      {"BetaMultinomialByInsertion", "beta_multinomial(2,5)", beta_multinomial_law(2, 5), urns(2, 5),
       "beta(2,5)", order_statistics(2, 5)},
      {"WideBetaMultinomialByInsertion", "beta_multinomial(0.3,0.2)", beta_multinomial_law(0.3, 0.2),
       urns(0.3, 0.2), "beta(0.3,0.2)", urns(0.2, 0.3)},
  };
}

INSTANTIATE_TEST_SUITE_P(Models, SecondConstruction, ::testing::ValuesIn(constructions()),
                         [](const auto& instance) { return instance.param.name; });

// beta(a,a+1) and beta(a,a) have the same law of unordered splits ((f(x)+f(1-x))/2 coincide): the same law of
// all that does not see sides, by different variates.
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
