// The likelihood of the splits of whole trees, family by family, against the split laws themselves.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/error_of.hpp"
#include "support/growing.hpp"
#include "support/seed.hpp"
#include "support/tree_files.hpp"
#include <boost/math/special_functions/beta.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/family/beta_cell.hpp"
#include "ramify/family/family.hpp"
#include "ramify/model/beta.hpp"

namespace ramify {
namespace {

/// A family at parameters, in the middle of its domain and near its ends.
struct FamilyCase {
  const char* family;
  std::vector<double> values;
};

const std::vector<FamilyCase>& family_cases() {
  static const std::vector<FamilyCase> cases{{"patricia", {0.011}},
                                             {"patricia", {0.2}},
                                             {"patricia", {0.5}},
                                             {"patricia", {0.83}},
                                             {"dst", {0.011}},
                                             {"dst", {0.2}},
                                             {"dst", {0.5}},
                                             {"dst", {0.83}},
                                             {"aldous", {-1.99}},
                                             {"aldous", {-1.5}},
                                             {"aldous", {-1.0005}},
                                             {"aldous", {-1}},
                                             {"aldous", {-0.9995}},
                                             {"aldous", {-0.99}},
                                             {"aldous", {0}},
                                             {"aldous", {3}},
                                             {"aldous", {150}},
                                             {"ford", {0}},
                                             {"ford", {0.3}},
                                             {"ford", {0.5}},
                                             {"ford", {0.9}},
                                             {"beta", {0.06, 0.06}},
                                             {"beta", {0.4, 2}},
                                             {"beta", {1, 1}},
                                             {"beta", {3, 0.7}},
                                             {"beta", {10, 40}},
                                             {"beta", {300, 200}},
                                             {"beta_multinomial", {0.06, 0.06}},
                                             {"beta_multinomial", {0.4, 2}},
                                             {"beta_multinomial", {1, 1}},
                                             {"beta_multinomial", {10, 40}},
                                             {"beta_multinomial", {300, 200}},
                                             {"bst", {}},
                                             {"catalan", {}},
                                             {"aldous(-1)", {}}};
  return cases;
}

/// Windows lose their digits where probabilities are below e^-600.
constexpr double least_log = 600;

std::string text_of(const FamilyCase& of) {
  std::string text = of.family;
  for (const double value : of.values) text += fmt::format(" {}", value);
  return text;
}

/// Minus the log of q(i) + q(n-1-i), or q(i) where they are the same split.
double minus_log(const std::vector<double>& pmf, Size i) {
  const Size other = pmf.size() - 1 - i;
  return -std::log(i == other ? pmf[i] : pmf[i] + pmf[other]);
}

/// The word of a tree whose root has `smaller` and `larger` internal nodes below its children, chains both.
Tree forked_chains(Size smaller, Size larger) {
  std::vector<std::uint32_t> word{2};
  for (const Size size : {smaller, larger}) {
    for (Size i = 0; i < size; ++i) word.insert(word.end(), {2, 0});
    word.push_back(0);
  }
  return Tree(std::move(word));
}

double value_of(const SplitLikelihood& likelihood, const std::vector<double>& at) {
  double value = std::nan("");
  EXPECT_TRUE(likelihood(at, value, nullptr));
  return value;
}

/// Minus the log-likelihood of a tree at parameters.
double likelihood_of(const FamilyCase& of, const Tree& tree) {
  const Family& family = find_family(of.family);
  return value_of(family.of_splits(ObservedSplits(tree, "t")), family.searched(of.values));
}

/// The product of the splits of a tree, node by node from the law's own windows.
double literal_product(const Model& model, const Tree& tree) {
  std::vector<Size> sizes;
  double sum = 0;
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    if (tree.arity(node) == 0) {
      sizes.push_back(0);
      continue;
    }
    const Size left = sizes.back();
    sizes.pop_back();
    const Size n = left + sizes.back() + 1;
    sizes.back() = n;
    sum += minus_log(split_pmf(model, n), left);
  }
  return sum;
}

Tree grown(const Model& model, Size n, std::uint64_t replicate) {
  return test::grown_tree(model, n, {test::seed_of("family likelihood"), n}, replicate);
}

TEST(FamilyLikelihood, IsTheProductOfTheSplitLawOverAllNodes) {
  for (const FamilyCase& of : family_cases()) {
    const Model model = find_family(of.family).at(of.values);
    for (const Size n : {3u, 4u, 7u, 30u, 200u}) {
      const Tree tree = grown(model, n, 0), other = grown(Model::parse("bst"), n, 1);
      const double own = literal_product(model, tree), strange = literal_product(model, other);
      EXPECT_NEAR(likelihood_of(of, tree), own, 1e-10 * (1 + static_cast<double>(n)))
          << text_of(of) << ' ' << n;
      if (strange < least_log) {
        EXPECT_NEAR(likelihood_of(of, other), strange, 2e-10 * (1 + strange)) << text_of(of) << ' ' << n;
      }
    }
  }
}

/// A root that divides in any way, and chains below it.
TEST(FamilyLikelihood, HoldsEverySplitOfARow) {
  for (const FamilyCase& of : family_cases()) {
    const Model model = find_family(of.family).at(of.values);
    for (const Size n : {5u, 64u, 130u, 301u}) {
      const auto pmf = split_pmf(model, n);
      std::vector<double> chains{0};  // minus the log-likelihood of a chain, as far as it goes
      for (Size size = 1; size < n; ++size) {
        const double step = minus_log(split_pmf(model, size), 0);
        chains.push_back(chains.back() + (step < least_log ? step : std::numeric_limits<double>::infinity()));
      }
      for (Size i = 0; 2 * i < n; i += 1 + n / 40) {
        const Size other = n - 1 - i;
        const double root = minus_log(pmf, i);
        if (!(root < least_log) || !std::isfinite(chains[other])) continue;
        const double expected = root + chains[i] + chains[other];
        EXPECT_NEAR(likelihood_of(of, forked_chains(i, other)), expected, 1e-10 * (1 + expected))
            << text_of(of) << ' ' << n << ' ' << i;
      }
    }
  }
}

TEST(FamilyLikelihood, GradientIsThatOfCentralDifferences) {
  for (const FamilyCase& of : family_cases()) {
    const Family& family = find_family(of.family);
    if (family.parameters.empty()) continue;
    for (const Size n : {12u, 1000u}) {
      const auto likelihood =
          family.of_splits(ObservedSplits(grown(Model::parse("aldous(-0.5)"), n, 2), "t"));
      const std::vector<double> at = family.searched(of.values);
      std::vector<double> gradient(at.size());
      double value = 0;
      ASSERT_TRUE(likelihood(at, value, gradient.data()));
      EXPECT_NEAR(value, value_of(likelihood, at), 1e-13 * std::abs(value));
      for (std::size_t i = 0; i < at.size(); ++i) {
        const auto moved = [&](double step) {
          std::vector<double> place = at;
          place[i] += step;
          return value_of(likelihood, place);
        };
        if (of.values[i] == 0 && std::string(of.family) == "ford") continue;  // the end of the domain
        const double h = 1e-3;                                                // five points: error h^4
        const double slope = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
        // Of p = 1/2 the slope is 0, and a kink it would be where the fold of p were no fold.
        EXPECT_NEAR(gradient[i], slope, 1e-6 * std::max(1.0, std::abs(slope)))
            << text_of(of) << ' ' << n << ' ' << i;
      }
    }
  }
}

TEST(FamilyLikelihood, AldousHasNoSeamAtMinusOneNorAtTheEndOfTheSeries) {
  const Family& family = find_family("aldous");
  const auto likelihood = family.of_splits(ObservedSplits(grown(Model::parse("bst"), 5000, 0), "t"));
  for (const double beta : {-1.001, -1.0, -0.999}) {
    double below = 0, above = 0, slope_below = 0, slope_above = 0;
    const double at = family.searched(std::vector<double>{beta})[0];
    ASSERT_TRUE(likelihood(std::vector<double>{at - 1e-9}, below, &slope_below));
    ASSERT_TRUE(likelihood(std::vector<double>{at + 1e-9}, above, &slope_above));
    EXPECT_NEAR(above - below, 2e-9 * slope_above, 1e-8) << beta;
    EXPECT_NEAR(slope_below, slope_above, 1e-4) << beta;  // their own difference is 5e-6
  }
}

TEST(FamilyLikelihood, BetaCellIsThatOfTheLaw) {
  std::size_t compared = 0;
  for (const auto& [a, b] : std::vector<std::pair<double, double>>{
           {0.05, 0.05}, {0.05, 400}, {0.3, 0.9}, {1, 1}, {2.5, 0.4}, {20, 30}, {500, 450}, {500, 0.05}}) {
    const Beta law(a, b);
    for (const Size n : {2u, 3u, 5u, 20u, 300u, 10000u})
      for (Size i = 0; 2 * i < n && n - 1 - i > 0; i += 1 + i / 2) {
        const double weight = law.cell_probability(i, n);
        if (!(weight > 1e-250)) continue;
        const LogCell cell = log_cell(LogBeta(a, b), static_cast<double>(i), static_cast<double>(n - 1 - i));
        // A difference of two incomplete betas is right to 1e-15 of the larger of them, no better.
        const double below = static_cast<double>(i) / static_cast<double>(n);
        const double share = std::min(boost::math::ibeta(a, b, below), boost::math::ibetac(a, b, below));
        const double known = std::max(1e-10, 1e-14 * share / weight);
        EXPECT_NEAR(cell.log, std::log(weight), known) << a << ' ' << b << ' ' << i << ' ' << n;
        ++compared;
      }
  }
  EXPECT_GT(compared, 200u);
}

TEST(ObservedSplits, CountsEachKindOnce) {
  // A root of two cherries' parents: 3 | 3, each a fork of 1 and 1.
  const ObservedSplits splits(test::tree_of("(((a,b),(c,d)),((e,f),(g,h)));").tree, "t");
  ASSERT_EQ(splits.splits().size(), 2u);
  EXPECT_EQ(splits.splits()[0].size(), 3u);
  EXPECT_EQ(splits.splits()[0].smaller, 1u);
  EXPECT_EQ(splits.splits()[0].count, 2);
  EXPECT_EQ(splits.splits()[1].size(), 7u);
  EXPECT_EQ(splits.nodes(), 7);
  EXPECT_EQ(splits.choices(), 3);
}

TEST(ObservedSplits, LeftAndRightMeanNothing) {
  const ObservedSplits left(test::tree_of("((((a,b),c),d),(e,f));").tree, "t");
  const ObservedSplits right(test::tree_of("((e,f),(d,(c,(a,b))));").tree, "t");
  ASSERT_EQ(left.splits().size(), right.splits().size());
  for (std::size_t i = 0; i < left.splits().size(); ++i) {
    EXPECT_EQ(left.splits()[i].smaller, right.splits()[i].smaller);
    EXPECT_EQ(left.splits()[i].larger, right.splits()[i].larger);
  }
}

TEST(ObservedSplits, OfSeveralTreesAddUp) {
  ObservedSplits both(grown(Model::parse("bst"), 40, 0), "t");
  const ObservedSplits other(grown(Model::parse("bst"), 70, 1), "u");
  for (const FamilyCase& of : family_cases()) {
    const Family& family = find_family(of.family);
    ObservedSplits sum = both;
    sum.add(other);
    const auto value = [&](const ObservedSplits& splits) {
      return value_of(family.of_splits(splits), family.searched(of.values));
    };
    EXPECT_NEAR(value(sum), value(both) + value(other), 1e-10 * value(sum)) << text_of(of);
  }
  both.add(other);
  EXPECT_EQ(both.nodes(), 110);
  EXPECT_EQ(std::vector<Size>(both.tree_sizes().begin(), both.tree_sizes().end()),
            (std::vector<Size>{40, 70}));
}

TEST(ObservedSplits, RefusesWhatIsNotBinary) {
  EXPECT_EQ(
      test::error_of([] { ObservedSplits(test::tree_of("((a,b,c),d);").tree, "my tree"); }),
      "my tree: a node with 3 children (families are fitted to binary trees): contract one-child nodes, "
      "resolve forks of three");
}

}  // namespace
}  // namespace ramify
