// Laws that depend on the node: every tree of a small size as often as its definition says.
#include <cmath>
#include <functional>
#include <string>

#include "support/goodness.hpp"
#include "support/reference_laws.hpp"
#include "support/word_law.hpp"
#include <gtest/gtest.h>

namespace ramify {
namespace {

using test::add_node;
using test::side_by_side;
using test::WordLaw;
using test::words_against;

/// P(left = i) of a node of that size and depth in a tree of size n.
using NodeSplitLaw = std::function<std::vector<double>(Size size, double depth, double n)>;

/// Every tree of `size` nodes whose root has that depth.
WordLaw binary_law(const NodeSplitLaw& split, Size size, Size depth, Size n) {
  if (size == 0) return {{"E", 1.0}};
  WordLaw law;
  const auto lefts = split(size, static_cast<double>(depth), static_cast<double>(n));
  for (Size left = 0; left < size; ++left)
    add_node(side_by_side(
                 {binary_law(split, left, depth + 1, n), binary_law(split, size - 1 - left, depth + 1, n)}),
             lefts[left], law);
  return law;
}

WordLaw law_of(const NodeSplitLaw& split, Size n) {
  return binary_law(split, n, 1, n);
}

struct NodeCase {
  const char* model;
  NodeSplitLaw split;
  const char* slip;
  NodeSplitLaw wrong;

  friend std::ostream& operator<<(std::ostream& out, const NodeCase& node) { return out << node.model; }
};

class NodeDependentModels : public testing::TestWithParam<NodeCase> {};

TEST_P(NodeDependentModels, HaveTheLawOfTheirDefinition) {
  const auto& [model, split, slip, wrong] = GetParam();
  for (const Size n : {Size{0}, Size{1}, Size{2}, Size{3}, Size{7}})
    EXPECT_TRUE(test::agrees(words_against(model, n, law_of(split, n), "")));
  EXPECT_TRUE(test::rejected(words_against(model, 7, law_of(wrong, 7), std::string(": ") + slip)));
}

using test::beta_law;
using test::dst_law;
using test::split_law;

// The four cells of Table 2.6 (A10), a binomial law of depth and size, and formulas that are constants.
INSTANTIATE_TEST_SUITE_P(
    Formulas, NodeDependentModels,
    testing::Values(NodeCase{"node_beta(d,d)", [](Size s, double d, double) { return beta_law(s, d, d); },
                             "the root has depth 0",
                             [](Size s, double d, double) { return beta_law(s, d - 0.5, d - 0.5); }},
                    NodeCase{"node_beta(n/size,n/size)",
                             [](Size s, double, double n) {
                               const double share = n / static_cast<double>(s);
                               return beta_law(s, share, share);
                             },
                             "n - 1 for n",
                             [](Size s, double, double n) {
                               const double share = (n - 1) / static_cast<double>(s);
                               return beta_law(s, share, share);
                             }},
                    NodeCase{"node_beta(d, 1)", [](Size s, double d, double) { return beta_law(s, d, 1); },
                             "a and b swapped", [](Size s, double d, double) { return beta_law(s, 1, d); }},
                    NodeCase{"node_beta(size >= n/2 ? 1 : 10, size >= n/2 ? 1 : 10)",
                             [](Size s, double, double n) {
                               const double a = static_cast<double>(s) >= n / 2 ? 1 : 10;
                               return beta_law(s, a, a);
                             },
                             "the other phase",
                             [](Size s, double, double n) {
                               const double a = static_cast<double>(s) >= n / 2 ? 10 : 1;
                               return beta_law(s, a, a);
                             }},
                    NodeCase{"node_dst(size > 4 ? 1/3.19 : 1/(3.19+log(d)))",
                             [](Size s, double d, double) {
                               return dst_law(s, s > 4 ? 1 / 3.19 : 1 / (3.19 + std::log(d)));
                             },
                             "logarithm to base 10",
                             [](Size s, double d, double) {
                               return dst_law(s, s > 4 ? 1 / 3.19 : 1 / (3.19 + std::log10(d)));
                             }},
                    NodeCase{"node_beta(2,5)", [](Size s, double, double) { return beta_law(s, 2, 5); },
                             "beta(2,5.5)", [](Size s, double, double) { return beta_law(s, 2, 5.5); }},
                    NodeCase{"node_split(1/(d+1))",
                             [](Size s, double d, double) { return split_law(s, 1 / (d + 1)); },
                             "the root has depth 0",
                             [](Size s, double d, double) { return split_law(s, 1 / (d + 0.5)); }}),
    [](const auto& instance) { return "Case" + std::to_string(instance.index); });

TEST(NodeTernary, HasTheLawOfItsDefinition) {
  const auto p_at = [](double d) { return 1 / (3 + std::log(d)); };
  for (const unsigned n : {0u, 1u, 2u, 7u})
    EXPECT_TRUE(test::agrees(words_against("node_ternary(1/(3+log(d)))", n, test::ternary_law(p_at, n), "")));
  EXPECT_TRUE(test::rejected(words_against("node_ternary(1/(3+log(d)))", 7, test::ternary_law(p_at, 7, 2),
                                           ": the root has depth 2")));
}

}  // namespace
}  // namespace ramify
