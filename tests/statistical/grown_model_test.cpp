// Models that are grown whole: every tree of a small size as often as its definition says, and known means at
// larger ones.
#include <cmath>
#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/reference_laws.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/shape.hpp"
#include "support/shape_counts.hpp"
#include "support/uninterrupted.hpp"
#include "support/word_law.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/law/bounded_law.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using test::add_node;
using test::binomial;
using test::side_by_side;
using test::WordLaw;
using test::words_against;

WordLaw trie_law(unsigned strings, double p) {
  if (strings < 2) return {{"E", 1.0}};
  // Without the strings all on one side, which leave the same number to the one child: that is summed over
  // its repetitions.
  WordLaw law;
  for (unsigned left = 1; left < strings; ++left)
    add_node(side_by_side({trie_law(left, p), trie_law(strings - left, p)}), binomial(strings, left, p), law);
  const double one_sided = binomial(strings, 0, p) + binomial(strings, strings, p);
  WordLaw with_chains;
  for (const auto& [word, q] : law) {
    std::string chained = word;
    for (double weight = q; weight > 1e-12; weight *= one_sided) {
      with_chains[chained] += weight;
      chained = "(" + chained + ")";
    }
  }
  return with_chains;
}

WordLaw branching_law(unsigned generations, double p0, double p1) {
  if (generations <= 1) return {{"E", 1.0}};
  const WordLaw below = branching_law(generations - 1, p0, p1);
  WordLaw law{{"E", p0}};
  add_node(below, p1, law);
  add_node(side_by_side({below, below}), 1 - p0 - p1, law);
  return law;
}

/// Given the number of nodes: of all trees with them, in proportion to the product of their nodes'
/// probabilities.
WordLaw galton_watson_law(unsigned n, double p0, double p1, double p2) {
  std::vector<WordLaw> weights{{}};
  for (unsigned nodes = 1; nodes <= n; ++nodes) {
    WordLaw law;
    if (nodes == 1) law["E"] = p0;
    add_node(weights[nodes - 1], p1, law);
    for (unsigned left = 1; left + 1 < nodes; ++left)
      add_node(side_by_side({weights[left], weights[nodes - 1 - left]}), p2, law);
    weights.push_back(law);
  }
  double sum = 0;
  for (const auto& [word, weight] : weights.back()) sum += weight;
  for (auto& [word, weight] : weights.back()) weight /= sum;
  return weights.back();
}

TEST(Trie, HasTheLawOfItsDefinition) {
  for (const unsigned n : {0u, 1u, 2u, 3u, test::sanitized ? 4u : 5u})
    EXPECT_TRUE(test::agrees(words_against("trie(0.3)", n, trie_law(n, 0.3), "")));
  if (test::sanitized) return;
  EXPECT_TRUE(test::rejected(words_against("trie(0.3)", 5, trie_law(5, 0.32), ", p off")));
}

TEST(Ternary, HasTheLawOfItsDefinition) {
  for (const unsigned n : {0u, 1u, 2u, 3u, 7u})
    EXPECT_TRUE(test::agrees(
        words_against("ternary(0.25)", n, test::ternary_law([](double) { return 0.25; }, n), "")));
  EXPECT_TRUE(test::rejected(
      words_against("ternary(0.25)", 6, test::ternary_law([](double) { return 0.27; }, 6), ", p off")));
}

TEST(Branching, HasTheLawOfItsDefinition) {
  for (const unsigned n : {1u, 2u, 3u, 4u})
    EXPECT_TRUE(test::agrees(words_against("branching(0.2,0.5,0.3)", n, branching_law(n, 0.2, 0.5), "")));
  EXPECT_TRUE(
      test::rejected(words_against("branching(0.2,0.5,0.3)", 4, branching_law(4, 0.22, 0.5), ", p0 off")));
}

TEST(GaltonWatson, HasTheLawOfItsDefinition) {
  for (const unsigned n : {1u, 2u, 3u, 6u, 7u})
    EXPECT_TRUE(test::agrees(
        words_against("galton_watson(0.2,0.5,0.3)", n, galton_watson_law(n, 0.2, 0.5, 0.3), "")));
  EXPECT_TRUE(
      test::agrees(words_against("galton_watson(0.5,0,0.5)", 9, galton_watson_law(9, 0.5, 0, 0.5), "")));
  EXPECT_TRUE(test::rejected(
      words_against("galton_watson(0.2,0.5,0.3)", 7, galton_watson_law(7, 0.2, 0.47, 0.33), ", p1 off")));
}

// Without its one-child nodes a trie is the PATRICIA tree of its strings.
TEST(Trie, ContractedHasThePatriciaShapes) {
  const Model trie = Model::parse("trie(0.3)");
  for (const std::size_t n : {1u, 3u, 7u}) {
    const auto shapes = test::all_shapes(n);
    const auto counts = test::count_shapes(shapes, 60'000, [&](std::uint64_t replicate) {
      Stream stream({test::seed_of("contracted tries"), n}, replicate);
      const Tree tree = trie.grown().grow(n + 1, stream, test::uninterrupted);
      std::vector<std::uint32_t> arity(tree.arities().begin(), tree.arities().end());
      std::erase(arity, 1u);
      return to_parentheses(Tree(arity));
    });
    const auto patricia = [](double p) { return [p](Size size) { return test::patricia_law(size, p); }; };
    const auto what = fmt::format("contracted trie(0.3) of {} strings", n + 1);
    EXPECT_TRUE(test::agrees(test::chi_square(what, counts, test::shape_law(shapes, n, patricia(0.3)))));
    if (n == 7) {
      EXPECT_TRUE(test::rejected(
          test::chi_square(what + ", p off", counts, test::shape_law(shapes, n, patricia(0.32)))));
    }
  }
}

// An order is what one-child nodes inherit, so a trie has that of its PATRICIA tree, exactly.
TEST(Trie, HasTheOrdersOfPatriciaTrees) {
  constexpr Size strings = 300;
  const Model trie = Model::parse("trie(0.23)");
  const auto law =
      build_law(Model::parse("patricia(0.23)"), strings, BoundedLaw(Strahler::recurrence, strings));
  const auto sampler = make_tree_sampler({trie, whole_trees(all_but_indices), strings, &test::uninterrupted});
  std::vector<std::uint64_t> orders(10, 0);
  TreeMeasures measures;
  for (std::uint64_t replicate = 0; replicate < test::replicates(20'000); ++replicate) {
    sampler->sample(strings, {test::seed_of("trie orders"), trie.stream_cell(strings)}, replicate, measures);
    ASSERT_EQ(measures.streams[0], strings);
    ++orders.at(measures.strahler);
  }
  const auto of = [&](Size n) {
    const auto pmf = law.pmf(n);
    std::vector<double> probabilities(pmf.begin(), pmf.end());
    probabilities.resize(orders.size(), 0.0);
    return probabilities;
  };
  EXPECT_TRUE(test::agrees(test::chi_square("orders of tries", orders, of(strings - 1))));
  EXPECT_TRUE(
      test::rejected(test::chi_square("orders of tries, 10 % fewer strings", orders, of(strings * 9 / 10))));
}

struct KnownMean {
  const char* model;
  Size n;
  std::uint64_t trees;
  const char* what;
  double (*value)(const TreeMeasures&);
  double mean;

  friend std::ostream& operator<<(std::ostream& out, const KnownMean& known) {
    return out << known.what << " of " << known.model;
  }
};

class GrownModels : public testing::TestWithParam<KnownMean> {};

TEST_P(GrownModels, HaveTheirKnownMeans) {
  const KnownMean& known = GetParam();
  const Model model = Model::parse(known.model);
  const auto sampler =
      make_tree_sampler({model, whole_trees(all_but_indices), known.n, &test::uninterrupted});
  test::SampleMean mean;
  TreeMeasures measures;
  for (std::uint64_t replicate = 0; replicate < test::replicates(known.trees); ++replicate) {
    sampler->sample(known.n, {test::seed_of("grown means"), model.stream_cell(known.n)}, replicate, measures);
    mean.add(known.value(measures));
  }
  EXPECT_TRUE(test::agrees(test::z_test(fmt::format("{} {}", known.model, known.what), mean, known.mean)));
}

double strahler_of(const TreeMeasures& m) {
  return m.strahler;
}
double size_of(const TreeMeasures& m) {
  return static_cast<double>(m.size);
}
template <std::size_t k>
double streams(const TreeMeasures& m) {
  return static_cast<double>(m.streams[k]);
}

#define RAMIFY_A17 "ramification(" RAMIFY_SOURCE_DIR "/data/ramification_bst.csv)"

// A22: exact, n = 1000. A17: exact, root order 6 of leaf order 1. tokunaga(1,2): given order K of leaf order
// 1 a critical Galton-Watson tree has (2 4^(K-1) + 1)/3 leaves.
INSTANTIATE_TEST_SUITE_P(
    Catalogue, GrownModels,
    testing::Values(KnownMean{"ternary(1/4.8)", 1000, 5'000, "order", strahler_of, 5.500746},
                    KnownMean{RAMIFY_A17, 5, 20'000, "internal nodes", size_of, 211.67030},
                    KnownMean{RAMIFY_A17, 5, 20'000, "streams 1", streams<1>, 74.7303},
                    KnownMean{RAMIFY_A17, 5, 20'000, "streams 4", streams<4>, 2.92308},
                    KnownMean{"tokunaga(1,2)", 4, 20'000, "leaves", streams<0>, 171}),
    [](const auto& instance) { return fmt::format("Case{}", instance.index); });

}  // namespace
}  // namespace ramify
