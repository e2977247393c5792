#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "support/growing.hpp"
#include "support/shape.hpp"
#include <gtest/gtest.h>

#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using Counts = std::vector<std::uint64_t>;

TreeMeasures measures_of(const std::string& model, Size n) {
  const Cancellation never;
  TreeMeasures measures;
  make_tree_sampler({Model::parse(model), whole_trees(orders_and_paths), max_size, &never})
      ->sample(n, {1, 2}, 3, measures);
  return measures;
}

Counts to_top(const HortonStrahler::Counts& counts, std::uint32_t order) {
  return {counts.begin(), counts.begin() + order + 1};
}

struct Oracle {
  std::string model;
  Size n;
  Counts nodes;
  Counts streams;
};

TEST(FixedSplitTree, HasThePrintedCounts) {
  const std::vector<Oracle> oracles{
      {"split(0.25)", 15, {16, 11, 4}, {16, 5, 1}},
      {"split(1/4.35)", 100, {101, 68, 25, 6, 1}, {101, 33, 8, 2, 1}},
      {"split(1/4.35)", 579, {580, 394, 140, 35, 8, 2}, {580, 186, 46, 11, 3, 1}}};
  for (const auto& [model, n, nodes, streams] : oracles) {
    const TreeMeasures measures = measures_of(model, n);
    EXPECT_EQ(to_top(measures.nodes, measures.strahler), nodes) << model << " n = " << n;
    EXPECT_EQ(to_top(measures.streams, measures.strahler), streams) << model << " n = " << n;
  }
}

TEST(FixedSplitTree, OfAQuarterAndFifteenIsThePrintedTree) {
  const auto source = test::tree_source("split(0.25)", {0, 0}, test::default_tables);
  EXPECT_EQ(to_parentheses(source(15, 0)), "((E(E(EE)))((E(EE))((E(EE))((EE)(E(E(EE)))))))");
  EXPECT_EQ(measures_of("split(0.25)", 15).height, 8u);
  EXPECT_EQ(measures_of("split(1/4.35)", 579).height, 22u);
}

TEST(FixedSplitTree, HasThePrintedOrders) {
  EXPECT_EQ(measures_of("split(1/2)", 2000).strahler, 10u);
  EXPECT_EQ(measures_of("split(1/3)", 2000).strahler, 7u);
  EXPECT_EQ(measures_of("split(1/4.35)", 100000).strahler, 8u);
}

TEST(FixedSplitTree, OfOneHalfIsComplete) {
  for (std::size_t levels = 1; levels <= 12; ++levels) {
    const Size n = (Size{1} << levels) - 1;
    const TreeMeasures measures = measures_of("split(0.5)", n);
    EXPECT_EQ(measures.strahler, levels);
    EXPECT_EQ(measures.height, levels + 1);
    EXPECT_EQ(measures.fill_level, levels);
    EXPECT_EQ(measures.balance, levels);
    EXPECT_EQ(measures.nodes, measures.streams);
    for (std::size_t k = 0; k < levels; ++k) EXPECT_EQ(measures.streams[k], 2 * measures.streams[k + 1]);
    EXPECT_NEAR(order_ratios(to_top(measures.nodes, measures.strahler)).mean_ratio, 2, 1e-14);
  }
}

TEST(CompleteTree, IsPerfectWhereItCanBe) {
  const auto source = test::tree_source("complete", {0, 0}, test::default_tables);
  for (std::size_t levels = 1; levels <= 6; ++levels)
    EXPECT_EQ(to_parentheses(source((Size{1} << levels) - 1, 0)),
              test::to_word(test::complete_shape(levels)));
  EXPECT_EQ(to_parentheses(source(5, 0)), "(((EE)(EE))(EE))");
  EXPECT_EQ(to_parentheses(source(6, 0)), "(((EE)(EE))((EE)E))");
}

// A3: order, fill level and balance number are as large as n allows, the height as small.
TEST(CompleteTree, IsExtremeAtEverySize) {
  for (Size n = 1; n <= 300; ++n) {
    const TreeMeasures measures = measures_of("complete", n);
    const auto most = static_cast<std::uint32_t>(std::bit_width(n + 1) - 1);
    EXPECT_EQ(measures.strahler, most) << n;
    EXPECT_EQ(measures.fill_level, most) << n;
    EXPECT_EQ(measures.balance, most) << n;
    EXPECT_EQ(measures.height, static_cast<std::uint32_t>(std::bit_width(n)) + 1) << n;
    EXPECT_EQ(measures.streams[1], (n + 1) / 2) << n;
  }
}

// A4: R_1 = (n+1)/n in nodes.
TEST(Chain, HasThePrintedCounts) {
  for (const Size n : {1u, 2u, 3u, 10u, 500u}) {
    const TreeMeasures measures = measures_of("chain", n);
    EXPECT_EQ(to_top(measures.nodes, measures.strahler), (Counts{n + 1, n}));
    EXPECT_EQ(to_top(measures.streams, measures.strahler), (Counts{n + 1, 1}));
    EXPECT_EQ(measures.height, n + 1);
    EXPECT_EQ(measures.depth, n);
    EXPECT_EQ(measures.fill_level, 1u);
  }
}

double bound_of_fact_32(double x, Size n) {
  return std::log(static_cast<double>(n)) / std::log(1 / x) + 1;
}

// Fact 3.2 (C10): S <= log_(1/X) n + 1 for X <= 1/2.
TEST(FixedSplitTree, ObeysFact32) {
  const Cancellation never;
  for (const double x : {0.5, 0.49, 0.4, 1.0 / 3, 0.3, 0.25, 1 / 4.35, 0.2, 0.125, 0.1, 0.05, 0.01}) {
    const FixedSplit law(x);
    const auto sampler = make_tree_sampler(
        {Model::make(FixedSplit::info(), std::array{x}), whole_trees(orders_and_height), max_size, &never});
    std::vector<std::size_t> order{0};
    for (Size n = 1; n <= 5000; ++n) {
      const std::size_t left = order[law.left(n)], right = order[n - 1 - law.left(n)];
      order.push_back(left == right ? left + 1 : std::max(left, right));
      ASSERT_LE(static_cast<double>(order[n]), bound_of_fact_32(x, n) + 1e-9) << "X = " << x << ", n = " << n;
      if (n % 499 != 0) continue;
      TreeMeasures measures;
      sampler->sample(n, {0, 0}, 0, measures);
      EXPECT_EQ(measures.strahler, order[n]);
    }
  }
}

TEST(FixedSplitTree, OfOneHalfBreaksTheBoundOfOneThird) {
  EXPECT_GT(measures_of("split(0.5)", 4095).strahler, bound_of_fact_32(1.0 / 3, 4095));
}

// What holds in every tree (C1, C2, C4, C17), on random ones.
TEST(RandomTrees, ObeyTheIdentities) {
  const Cancellation never;
  for (const auto& text : test::all_models()) {
    const Model model = Model::parse(text);
    const auto sampler = make_tree_sampler({model, whole_trees(orders_and_paths), max_size, &never});
    TreeMeasures m;
    for (const Size n : {1u, 2u, 5u, 31u, 200u, 1000u, 30000u}) {
      for (std::uint64_t replicate = 0; replicate < 20; ++replicate) {
        sampler->sample(n, {7, model.stream_cell(n)}, replicate, m);
        EXPECT_EQ(m.size, n);
        EXPECT_EQ(m.nodes[0], n + 1);
        EXPECT_EQ(m.streams[0], n + 1);
        EXPECT_EQ(m.streams[m.strahler], 1u);
        EXPECT_LE(m.fill_level, m.strahler);
        EXPECT_LE(m.strahler, m.balance);
        EXPECT_LE(Size{1} << m.balance, n + 1);
        EXPECT_LT(m.fill_level, m.height);
        EXPECT_GE(m.depth, 1u);
        EXPECT_LT(m.depth, m.height);
        Size sum = 0;
        for (std::size_t k = 1; k < HortonStrahler::orders; ++k) sum += m.nodes[k];
        EXPECT_EQ(sum, n);
        for (std::size_t k = 0; k < m.strahler; ++k) EXPECT_GE(m.streams[k], 2 * m.streams[k + 1]);
        for (std::size_t k = 0; k <= m.strahler; ++k) EXPECT_LE(m.streams[k], m.nodes[k]);
      }
    }
  }
}

}  // namespace
}  // namespace ramify
