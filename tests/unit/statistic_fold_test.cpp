#include <map>
#include <string>
#include <vector>

#include "support/definitions.hpp"
#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/shape.hpp"
#include <gtest/gtest.h>

#include "ramify/random/stream.hpp"
#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/fill_level.hpp"
#include "ramify/statistic/height.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/joint.hpp"
#include "ramify/statistic/last_node_depth.hpp"
#include "ramify/tree/measure.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using Counts = std::vector<std::uint64_t>;
using Everything = Joint<Height, HortonStrahler, FillLevel, Balance>;

Counts trimmed(const HortonStrahler::Counts& counts, std::size_t top) {
  return {counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(top) + 1};
}

/// Every deterministic fold of the tree against its definition.
void expect_fold_definitions(const test::Shape& shape) {
  const std::string word = test::to_word(shape);
  SCOPED_TRACE(word.size() < 200 ? word : "a long word");
  Everything fold;
  const auto root = measure(from_parentheses(word), fold);
  EXPECT_EQ(get<0>(root), test::height(shape));
  const std::size_t order = get<1>(root);
  EXPECT_EQ(order, test::strahler(shape));
  EXPECT_EQ(get<2>(root), test::level_of_first_gap(shape));
  EXPECT_EQ(get<3>(root), test::balance(shape));
  const auto& orders = fold.get<HortonStrahler>();
  EXPECT_EQ(trimmed(orders.nodes(), order), test::nodes_per_order(shape));
  EXPECT_EQ(trimmed(orders.streams(), order), test::streams_per_order(shape));
  for (std::size_t k = order + 1; k < HortonStrahler::orders; ++k) {
    EXPECT_EQ(orders.nodes()[k], 0u);
    EXPECT_EQ(orders.streams()[k], 0u);
  }
}

TEST(Folds, AreTheDefinitionsOnEveryTreeToEightNodes) {
  for (std::size_t n = 0; n <= 8; ++n) {
    const auto shapes = test::all_shapes(n);
    const std::vector<std::size_t> catalan{1, 1, 2, 5, 14, 42, 132, 429, 1430};
    EXPECT_EQ(shapes.size(), catalan[n]);
    for (const auto& shape : shapes) {
      expect_fold_definitions(shape);
      EXPECT_EQ(test::strahler(shape), test::strahler_by_pruning(shape));
      EXPECT_EQ(test::level_of_first_gap(shape), test::fill_level(shape));
    }
  }
}

TEST(Folds, ObeyTheBoundsOnEveryTreeToEightNodes) {
  for (std::size_t n = 0; n <= 8; ++n) {
    for (const auto& shape : test::all_shapes(n)) {
      Everything fold;
      const auto root = measure(from_parentheses(test::to_word(shape)), fold);
      const auto streams = fold.get<HortonStrahler>().streams();
      EXPECT_LE(get<2>(root), get<1>(root));  // F <= S (C17, B.4)
      EXPECT_LE(get<1>(root), get<3>(root));  // S <= B (C17, B.3)
      EXPECT_LE(get<1>(root), HortonStrahler::largest_order(n));
      EXPECT_EQ(streams[get<1>(root)], 1u);
      for (std::size_t k = 0; k < get<1>(root); ++k) EXPECT_GE(streams[k], 2 * streams[k + 1]);  // C4
    }
  }
}

TEST(Folds, AreTheDefinitionsOnWiderTrees) {
  for (const char* word : {"(EEE)", "(EEEE)", "((EE)EE)", "((EE)(EE)E)", "((EEE)(EE)(EE))",
                           "(E(EEE)((EE)(EE)))", "(((EE)(EE))((EE)(EE))(EEE))", "(E((EEE)(EEE)(EEE))(EE)E)"})
    expect_fold_definitions(test::read_shape(word));
}

// B22: one more than the largest order m where two children or more have it, however many.
TEST(HortonStrahler, TakesTheKaryRule) {
  const std::vector<std::pair<const char*, std::size_t>> trees{
      {"(EEE)", 1},     {"(EEEEEE)", 1}, {"((EE)EE)", 1}, {"((EE)(EE)E)", 2}, {"(E(EE)E(EE)(EE))", 2},
      {"((E)(EE))", 1}, {"((EE))", 1}};
  for (const auto& [word, order] : trees) {
    HortonStrahler fold;
    EXPECT_EQ(measure(from_parentheses(word), fold), order) << word;
  }
}

TEST(HortonStrahler, KnowsTheLargestOrder) {
  const std::vector<std::pair<Size, std::size_t>> sizes{{0, 0}, {1, 1}, {2, 1},     {3, 2},
                                                        {6, 2}, {7, 3}, {1023, 10}, {max_size, 62}};
  for (const auto& [n, order] : sizes) EXPECT_EQ(HortonStrahler::largest_order(n), order);
}

TEST(Folds, OnAChain) {
  for (const std::size_t n : {1u, 2u, 5u, 60u}) {
    const auto shape = test::right_chain(n);
    expect_fold_definitions(shape);
    EXPECT_EQ(test::strahler(shape), 1u);
    EXPECT_EQ(test::height(shape), n + 1);
    EXPECT_EQ(test::nodes_per_order(shape), (Counts{n + 1, n}));
    EXPECT_EQ(test::streams_per_order(shape), (Counts{n + 1, 1}));
  }
}

TEST(Folds, OnACompleteTree) {
  for (std::size_t levels = 0; levels <= 7; ++levels) {
    const auto shape = test::complete_shape(levels);
    expect_fold_definitions(shape);
    EXPECT_EQ(test::strahler(shape), levels);
    EXPECT_EQ(test::height(shape), levels + 1);
    EXPECT_EQ(test::fill_level(shape), levels);
    EXPECT_EQ(test::balance(shape), levels);
    const auto streams = test::streams_per_order(shape);
    for (std::size_t k = 0; k < levels; ++k) EXPECT_EQ(streams[k], 2 * streams[k + 1]);
  }
}

struct Fixture {
  const char* source;
  const char* word;
  std::uint64_t size;
  std::uint32_t height;
  Counts nodes;
  Counts streams;  // empty where none are printed

  friend std::ostream& operator<<(std::ostream& out, const Fixture& fixture) { return out << fixture.source; }
};

class DrawnTrees : public ::testing::TestWithParam<Fixture> {};

TEST_P(DrawnTrees, HaveThePrintedStatistics) {
  const Fixture& fixture = GetParam();
  const Tree tree = from_parentheses(fixture.word);
  expect_fold_definitions(test::read_shape(fixture.word));
  Everything fold;
  const auto root = measure(tree, fold);
  EXPECT_EQ(tree.size(), fixture.size);
  EXPECT_EQ(get<0>(root), fixture.height);
  EXPECT_EQ(get<1>(root), fixture.nodes.size() - 1);
  EXPECT_EQ(trimmed(fold.get<HortonStrahler>().nodes(), get<1>(root)), fixture.nodes);
  if (!fixture.streams.empty()) {
    EXPECT_EQ(trimmed(fold.get<HortonStrahler>().streams(), get<1>(root)), fixture.streams);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Catalogue, DrawnTrees,
    ::testing::Values(
        Fixture{"A2",
                "(((E(EE))E)(((E(EE))(((EE)E)E))((EE)((((EE)((EE)E))E)((E(EE))E)))))",
                22,
                9,
                {23, 15, 5, 2},
                {}},
        Fixture{"A2b",
                "((E(EE))(((EE)((EE)E))(((((E(EE))E)E)(E((E(EE))(EE))))(E(E(EE))))))",
                22,
                9,
                {23, 15, 5, 2},
                {}},
        Fixture{"A6", "((E(E(EE)))((E(EE))((E(EE))((EE)(E(E(EE)))))))", 15, 8, {16, 11, 4}, {16, 5, 1}},
        Fixture{"B8", "((((EE)E)E)(((EE)E)E))", 7, 5, {8, 6, 1}, {8, 2, 1}},
        Fixture{"A13", "((EE)((EE)E))", 4, 4, {5, 3, 1}, {5, 2, 1}}),
    [](const auto& instance) { return std::string(instance.param.source); });

// The walk to the last node, tree by tree: every depth as often as the definition says.
TEST(LastNodeDepth, FollowsItsLawOnStoredTrees) {
  std::uint64_t replicate = 0;
  for (const char* word :
       {"((EE)(EE))", "((E(E(EE)))((E(EE))((E(EE))((EE)(E(E(EE)))))))", "((EE)((EE)E)(E(EE)E))"}) {
    const Tree tree = from_parentheses(word);
    const auto law = test::last_node_depth_law(test::read_shape(word));
    std::vector<std::uint64_t> counts(16, 0);
    for (std::uint64_t i = 0; i < test::replicates(40'000); ++i) {
      LastNodeDepth fold{RandomWalk(Stream({test::seed_of("walks"), 0}, replicate++, Lane::walk))};
      ++counts.at(measure(tree, fold));
    }
    std::vector<double> probabilities(16, 0.0), edges(16, 0.0);
    for (const auto& [depth, p] : law) probabilities.at(depth) = p, edges.at(depth - 1) = p;
    EXPECT_TRUE(test::agrees(test::chi_square("last node", counts, probabilities)));
    EXPECT_TRUE(test::rejected(test::chi_square("last node, edges for nodes", counts, edges)));
  }
}

TEST(LastNodeDepth, IsZeroWithoutANodeAndOneAtASingleOne) {
  LastNodeDepth fold{RandomWalk(Stream({0, 0}, 0, Lane::walk))};
  EXPECT_EQ(measure(from_parentheses("E"), fold), 0u);
  EXPECT_EQ(measure(from_parentheses("(EE)"), fold), 1u);
  EXPECT_EQ(measure(from_parentheses("(E(EE))"), fold), 2u);
  EXPECT_EQ(measure(from_parentheses("((EE)E)"), fold), 2u);
}

}  // namespace
}  // namespace ramify
