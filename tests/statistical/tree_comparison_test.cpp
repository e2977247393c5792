// Is a tree like a model: trees of the model are not rejected more often than they should be, others are.
#include "ramify/compare/tree_comparison.hpp"

#include <cmath>
#include <map>
#include <string>

#include "support/error_of.hpp"
#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/shape.hpp"
#include "support/uninterrupted.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/statistic/registry.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

Tree tree_of(const Model& model, Size n, std::uint64_t replicate) {
  return test::grown_tree(model, n, {test::seed_of("compared"), 0}, replicate);
}

/// How often each statistic's p-value is at most 0.05.
std::map<std::string, double> rejections(const Model& grown, const Model& model, std::uint64_t trees) {
  std::map<std::string, double> rejected;
  for (std::uint64_t replicate = 0; replicate < trees; ++replicate) {
    const Simulation simulation{test::seed_of("simulated") + replicate, 99, 1};
    for (const auto& row :
         TreeComparison(model, simulation, test::uninterrupted)(tree_of(grown, 60, replicate), "tree"))
      rejected[row.column.name()] += row.p_value <= 0.05 ? 1 : 0;
  }
  return rejected;
}

// 4.75 standard deviations above 5 %: one in a million.
double most_expected(std::uint64_t trees) {
  const double count = static_cast<double>(trees);
  return 0.05 * count + 4.75 * std::sqrt(0.05 * 0.95 * count);
}

TEST(TreeComparison, RejectsTreesOfTheModelNoMoreThanItShould) {
  constexpr std::uint64_t trees = test::replicates(400);
  for (const char* text : {"bst", "patricia(0.3)"})
    for (const auto& [name, count] : rejections(Model::parse(text), Model::parse(text), trees)) {
      std::printf("  %s, %s: p <= 0.05 in %g of %u\n", text, name.c_str(), count,
                  static_cast<unsigned>(trees));
      EXPECT_LE(count, most_expected(trees)) << text << " " << name;
    }
}

TEST(TreeComparison, RejectsTreesOfAnotherModel) {
  constexpr std::uint64_t trees = 60;
  const auto counts = rejections(Model::parse("catalan"), Model::parse("bst"), trees);
  for (const char* name : {"sackin", "colless", "height"})
    EXPECT_GT(counts.at(name), most_expected(trees)) << name;
}

TEST(TreeComparison, GivesAChainItsNumbers) {
  const Tree chain = from_parentheses(test::to_word(test::right_chain(40)));
  const auto rows = TreeComparison(Model::parse("bst"), {1, 999, 2}, test::uninterrupted)(chain, "tree");
  ASSERT_EQ(rows.size(), 10u);
  for (const auto& row : rows) {
    EXPECT_GE(row.adjusted_p, row.p_value);
    if (row.column == statistic::height) {
      EXPECT_EQ(row.observed, 41);
      EXPECT_TRUE(row.exact);
      // 2^39/40! of all BSTs are chains: below what a law of heights keeps.
      EXPECT_EQ(row.p_value, 1e-20);
      EXPECT_TRUE(row.is_bound);
      EXPECT_GT(row.effect(), 5);
    }
    if (row.column == statistic::sackin) {
      EXPECT_FALSE(row.exact);
      EXPECT_EQ(row.p_value, 2.0 / 1000);
    }
  }
}

TEST(TreeComparison, DoesNotDependOnTheThreads) {
  const Tree tree = tree_of(Model::parse("bst"), 200, 1);
  const auto one = TreeComparison(Model::parse("beta(2,2)"), {1, 199, 1}, test::uninterrupted)(tree, "tree");
  const auto three =
      TreeComparison(Model::parse("beta(2,2)"), {1, 199, 3}, test::uninterrupted)(tree, "tree");
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].p_value, three[i].p_value);
    EXPECT_EQ(one[i].expected, three[i].expected);
  }
}

std::string refusal(const char* word, const char* model) {
  return test::error_of([&] {
    TreeComparison(Model::parse(model), {1, 99, 1}, test::uninterrupted)(from_parentheses(word), "my.txt:3");
  });
}

TEST(TreeComparison, RefusesWhatCannotBeCompared) {
  EXPECT_TRUE(refusal("(EE)", "bst").starts_with("my.txt:3: n = 1"));
  EXPECT_NE(refusal("((EEE)E)", "bst").find("binary"), std::string::npos);
  EXPECT_NE(refusal("((EE)E)", "trie(0.3)").find("internal nodes"), std::string::npos);
  EXPECT_EQ(refusal("((EEE)EE)", "ternary(0.3)"), "");
}

}  // namespace
}  // namespace ramify
