// Every statistic that `ramify list statistics` names, as it is read off one pass over a tree, against its
// definition.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "support/definitions.hpp"
#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/shape.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/sample/measure_tree.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/statistic/registry.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using Values = std::map<std::string, double>;
using Counts = std::vector<std::uint64_t>;

double quotient(std::uint64_t above, std::uint64_t below) {
  return below == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(above) / static_cast<double>(below);
}

Values measured(const test::Shape& shape, std::uint64_t replicate = 0) {
  const TreeMeasures measures =
      measure_tree(from_parentheses(test::to_word(shape)), {test::seed_of("measured"), 0}, replicate);
  Values values;
  for (const StatisticColumn& column : StatisticSet::all().columns(measures.strahler + 1))
    values[column.name()] = column.real_value(measures);
  return values;
}

void define_ratios(const std::string& name, const Counts& counts, Values& values) {
  if (counts.size() < 2) return;
  const OrderRatios ratios =
      order_ratios(counts);  // held against its definition in statistic_order_ratios_test.cpp
  values[name + "_mean_ratio"] = test::mean_ratio(counts);
  values[name + "_regression"] = ratios.regression;
  values[name + "_geometric"] = ratios.geometric;
}

void define_orders(const test::Shape& shape, Values& values) {
  const auto nodes = test::nodes_per_order(shape), streams = test::streams_per_order(shape);
  const auto joined = test::bi_orders(shape), side = test::side_branches(shape);
  const auto at = [](const auto& pairs, std::size_t i, std::size_t j) {
    const auto found = pairs.find({i, j});
    return found == pairs.end() ? std::uint64_t{0} : found->second;
  };
  define_ratios("nodes", nodes, values);
  define_ratios("streams", streams, values);
  if (nodes.size() > 1) {
    const double ratio = test::mean_ratio(nodes);
    double size = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i)
      size += std::pow(ratio, static_cast<double>(nodes.size() - 1 - i));
    values["horton_size"] = size;
    const double n = static_cast<double>(test::internal_nodes(shape));
    values["horton_order"] = ratio == 1 ? n : std::log(n * (ratio - 1) + 1) / std::log(ratio);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    values[fmt::format("nodes_{}", i)] = static_cast<double>(nodes[i]);
    values[fmt::format("streams_{}", i)] = static_cast<double>(streams[i]);
    if (i == 0) continue;
    values[fmt::format("nodes_ratio_{}", i)] = quotient(nodes[i - 1], nodes[i]);
    values[fmt::format("streams_ratio_{}", i)] = quotient(streams[i - 1], streams[i]);
    values[fmt::format("stream_length_{}", i)] = quotient(nodes[i], streams[i]);
    std::uint64_t of_order = at(joined, i - 1, i - 1), tributaries = 0, receivers = 0;
    for (std::size_t j = 0; j < i; ++j) of_order += at(joined, i, j);
    for (std::size_t j = 0; j < i; ++j) {
      values[fmt::format("ramification_{}_{}", i, j)] = quotient(at(joined, i, j), of_order);
      values[fmt::format("side_branches_{}_{}", i, j)] = quotient(at(side, i, j), streams[i]);
    }
    values[fmt::format("ramification_{0}_{0}", i)] = quotient(at(joined, i - 1, i - 1), of_order);
    for (std::size_t high = i; high < streams.size(); ++high) {
      tributaries += at(side, high, high - i);
      receivers += streams[high];
    }
    values[fmt::format("tokunaga_{}", i)] = quotient(tributaries, receivers);
  }
}

bool is_binary(const test::Shape& shape) {
  return shape.children.size() <= 2 && std::ranges::all_of(shape.children, is_binary);
}

void define_indices(const test::Shape& shape, Values& values) {
  const auto levels = test::nodes_per_level(shape);
  const double undefined = std::numeric_limits<double>::quiet_NaN();
  const auto of_binary = [&](double value) { return is_binary(shape) ? value : undefined; };
  values["total_cophenetic"] = test::total_cophenetic(shape);
  values["rooted_quartets"] = of_binary(test::rooted_quartets(shape));
  values["b1"] = test::b1(shape);
  values["b2"] = test::b2(shape);
  values["average_leaf_depth"] = test::average_leaf_depth(shape);
  values["variance_leaf_depth"] = test::variance_leaf_depth(shape);
  values["maximum_width_over_maximum_depth"] =
      quotient(*std::max_element(levels.begin(), levels.end()), test::height(shape) - 1);
  values["stairs1"] = of_binary(test::stairs1(shape));
  values["stairs2"] = of_binary(test::stairs2(shape));
  values["symmetry_nodes"] = of_binary(static_cast<double>(test::symmetry_nodes(shape)));
  values["pitchforks"] = static_cast<double>(test::pitchforks(shape));
  values["j1"] = test::j1(shape);
}

/// Of the walks, which are random, the test below takes care.
Values defined(const test::Shape& shape) {
  const auto levels = test::nodes_per_level(shape);
  const auto real = [](std::uint64_t value) { return static_cast<double>(value); };
  Values values{{"size", real(test::internal_nodes(shape))},
                {"magnitude", real(test::external_nodes(shape))},
                {"strahler", real(test::strahler(shape))},
                {"registers", real(test::strahler(shape) + 1)},
                {"height", real(test::height(shape))},
                {"path_length", real(test::path_length(shape))},
                {"sackin", real(test::sackin(shape))},
                {"colless", test::colless(shape)},
                {"cherries", real(test::cherries(shape))},
                {"width", real(*std::max_element(levels.begin(), levels.end()))},
                {"fill_level", real(test::level_of_first_gap(shape))},
                {"balance", real(test::balance(shape))},
                {"alternate_balance", real(test::balance(shape) + 1)}};
  define_orders(shape, values);
  define_indices(shape, values);
  return values;
}

void expect_definitions(const test::Shape& shape) {
  SCOPED_TRACE(test::to_word(shape));
  Values truth = defined(shape);
  for (const auto& [name, value] : measured(shape)) {
    if (name == "depth" || name == "external_depth") continue;
    const auto found = truth.find(name);
    // What the tree does not have, a count of an order above its own or a ratio to it, is 0 or undefined.
    const double expected = found != truth.end() ? found->second : std::isnan(value) ? value : 0;
    if (std::isnan(expected)) {
      EXPECT_TRUE(std::isnan(value)) << name << " is " << value;
    } else {
      EXPECT_NEAR(value, expected, 1e-12 * (1 + expected)) << name;
    }
    truth.erase(name);
  }
  EXPECT_TRUE(truth.empty()) << truth.begin()->first << " was not measured";
}

TEST(EveryStatistic, IsItsDefinitionOnEveryTreeToEightNodes) {
  for (std::size_t n = 0; n <= 8; ++n)
    for (const auto& shape : test::all_shapes(n)) expect_definitions(shape);
}

TEST(EveryStatistic, IsItsDefinitionOnWiderTrees) {
  for (const char* word :
       {"(EEE)", "(EEEE)", "((EE)EE)", "((EE)(EE)E)", "((EEE)(EE)(EE))", "(E(EEE)((EE)(EE)))",
        "(((EE)(EE))((EE)(EE))(EEE))", "(E((EEE)(EEE)(EEE))(EE)E)", "((EE)((EE)(EE)(EE)E))"})
    expect_definitions(test::read_shape(word));
}

TEST(EveryStatistic, IsItsDefinitionOnTreesWithOneChildNodes) {
  for (const char* word :
       {"(E)", "((E))", "((EE))", "((E)E)", "((E)(EE))", "(((E)E))", "((((E)(E))((EE)))E)", "((E)(E)((EE)))"})
    expect_definitions(test::read_shape(word));
}

// The trie of A12: its balance number is 2, its fill level 1 (the thesis says 2; X32), its alternate balance
// number 3 (X33).
TEST(EveryStatistic, OfTheTrieOfTheThesis) {
  const Values values = measured(test::read_shape("((((EE)))((EE)E))"));
  EXPECT_EQ(values.at("balance"), 2);
  EXPECT_EQ(values.at("fill_level"), 1);
  EXPECT_EQ(values.at("alternate_balance"), 3);
  EXPECT_EQ(values.at("size"), 6);
  EXPECT_EQ(values.at("magnitude"), 5);
}

TEST(EveryStatistic, IsItsDefinitionOnChainsAndCompleteTrees) {
  for (const std::size_t n : {1u, 2u, 30u}) expect_definitions(test::right_chain(n));
  for (std::size_t levels = 0; levels <= 5; ++levels) expect_definitions(test::complete_shape(levels));
}

// B21: no order of evaluation needs fewer registers than the Horton-Strahler number + 1, and one needs no
// more.
TEST(Registers, AreWhatTheBestOrderOfEvaluationNeeds) {
  for (std::size_t n = 0; n <= 8; ++n)
    for (const auto& shape : test::all_shapes(n))
      EXPECT_EQ(test::registers(shape), test::strahler(shape) + 1);
}

TEST(ExternalDepth, FollowsItsLawOnStoredTrees) {
  std::uint64_t replicate = 0;
  for (const char* word :
       {"(E(EE))", "((EE)((EE)E)(E(EE)E))", "((E(E(EE)))((E(EE))((E(EE))((EE)(E(E(EE)))))))"}) {
    const test::Shape shape = test::read_shape(word);
    std::vector<std::uint64_t> counts(16, 0);
    for (std::uint64_t i = 0; i < test::replicates(40'000); ++i)
      ++counts.at(static_cast<std::size_t>(measured(shape, replicate++).at("external_depth")));
    std::vector<double> probabilities(16, 0.0), edges(16, 0.0);
    for (const auto& [depth, p] : test::external_depth_law(shape))
      probabilities.at(depth) = p, edges.at(depth - 1) = p;
    EXPECT_TRUE(test::agrees(test::chi_square("external node", counts, probabilities)));
    EXPECT_TRUE(test::rejected(test::chi_square("external node, edges for nodes", counts, edges)));
  }
}

}  // namespace
}  // namespace ramify
