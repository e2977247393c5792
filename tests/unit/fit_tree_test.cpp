// Families fitted to whole trees by the likelihood of their splits.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/error_of.hpp"
#include "support/seed.hpp"
#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/fit/tree_bootstrap.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/text/csv_reader.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

const Cancellation never;

std::vector<RecordedTree> trees_of_model(const char* model, Size n, std::uint64_t count) {
  return TreeBatch{Model::parse(model), n, test::seed_of("fit tree"), 1, false}.grown(0, count, never);
}

FamilyFit fitted_family(const char* family, const Tree& tree) {
  const Family& of = find_family(family);
  const ObservedSplits splits(tree, "t");
  return fit_family(of, tree_objective(of, splits), splits.nodes());
}

std::vector<const Family*> chosen(std::initializer_list<const char*> names) {
  std::vector<const Family*> found;
  for (const char* name : names) found.push_back(&find_family(name));
  return found;
}

/// Maxima, standard errors and profile intervals of a program of 30 digits.
TEST(FitTree, AldousIsThatOfThirtyDigits) {
  RAMIFY_NEEDS_SHARED_FILES();
  const std::string peers_folder = test::shared_file("../peers/");
  const CsvData peers = CsvData::read(peers_folder + "beta.csv");
  std::size_t compared = 0;
  for (std::size_t row = 0; row < peers.rows(); ++row) {
    if (!peers.at(row, "peer").starts_with("definition")) continue;
    const std::string name(peers.at(row, "tree"));
    const FamilyFit fit =
        fitted_family("aldous", test::tree_of(read_text_file(peers_folder + "trees/" + name)).tree);
    const FittedParameter& beta = fit.parameters[0];
    EXPECT_TRUE(fit.converged && !fit.at_end && !beta.lower_open && !beta.upper_open) << name;
    EXPECT_NEAR(beta.estimate, peers.real(row, "beta"), 1e-7) << name;
    EXPECT_NEAR(beta.lower, peers.real(row, "lower"), 1e-7) << name;
    EXPECT_NEAR(beta.upper, peers.real(row, "upper"), 1e-6) << name;
    EXPECT_NEAR(beta.standard_error, peers.real(row, "standard_error"), 1e-5) << name;
    EXPECT_NEAR(fit.log_likelihood, peers.real(row, "loglik_unordered"), 1e-7) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 5u);
}

TEST(FitTree, AldousContainsTheBetaOfItsTrees) {
  struct Known {
    const char* model;
    double beta;
  };
  for (const auto& [model, beta] : {Known{"bst", 0}, {"catalan", -1.5}, {"aldous(-1)", -1}})
    for (const Size n : {100u, 10000u}) {
      const FittedParameter fit = fitted_family("aldous", trees_of_model(model, n, 1)[0].tree).parameters[0];
      EXPECT_LT(fit.lower, beta) << model << ' ' << n;
      EXPECT_GT(fit.upper, beta) << model << ' ' << n;
    }
}

TEST(FitTree, EveryFamilyComesBackToItsOwnParameters) {
  struct Known {
    const char *family, *model;
    std::vector<double> values;
  };
  const std::vector<Known> all{
      {"patricia", "patricia(0.2)", {0.2}}, {"dst", "dst(0.7)", {0.3}},
      {"aldous", "aldous(1)", {1}},         {"ford", "ford(0.3)", {0.3}},
      {"beta", "beta(5,2)", {2, 5}},        {"beta_multinomial", "beta_multinomial(0.3,3)", {0.3, 3}}};
  for (const auto& [family, model, values] : all) {
    const FamilyFit fit = fitted_family(family, trees_of_model(model, 3000, 1)[0].tree);
    ASSERT_TRUE(fit.converged && !fit.at_end) << model;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const FittedParameter& found = fit.parameters[i];
      EXPECT_NEAR(found.estimate, values[i], 4 * found.standard_error) << model;
      EXPECT_LT(found.lower, found.estimate) << model;
      EXPECT_GT(found.upper, found.estimate) << model;
      // Both say the same of a tree so large: half the interval is 1.96 standard errors.
      EXPECT_NEAR((found.upper - found.lower) / 2 / 1.96, found.standard_error, 0.2 * found.standard_error)
          << model;
    }
  }
}

/// (a,b) and (b,a) are one law: errors belong to the parameter they stand by, whichever way the search found
/// it.
TEST(FitTree, PairsAreInOrderWithTheirErrors) {
  const FamilyFit fit = fitted_family("beta", trees_of_model("beta(5,2)", 3000, 1)[0].tree);
  const auto& a = fit.parameters[0];
  const auto& b = fit.parameters[1];
  EXPECT_LT(a.estimate, b.estimate);
  EXPECT_LT(a.standard_error, b.standard_error);
  EXPECT_LT(a.upper, b.upper);
  EXPECT_LT(a.lower, b.lower);
}

TEST(FitTree, SaysWhereNothingBoundsAParameter) {
  const FamilyFit chain = fitted_family("aldous", trees_of_model("chain", 30, 1)[0].tree);
  EXPECT_TRUE(chain.at_end && chain.parameters[0].lower_open);
  EXPECT_FALSE(chain.parameters[0].upper_open);
  EXPECT_TRUE(std::isnan(chain.parameters[0].standard_error));
  const FamilyFit complete = fitted_family("aldous", trees_of_model("complete", 31, 1)[0].tree);
  EXPECT_TRUE(complete.at_end && complete.parameters[0].upper_open);
}

TEST(FitTree, FamiliesComeByAic) {
  const auto trees = trees_of_model("catalan", 500, 2);
  const auto fits = fit_trees(trees, chosen({"bst", "aldous", "catalan", "dst"}), {}, never);
  ASSERT_EQ(fits.size(), 2u);
  for (const TreeFit& fit : fits) {
    EXPECT_EQ(fit.nodes, 500);
    EXPECT_TRUE(std::ranges::is_sorted(fit.families, {}, &FamilyFit::aic));
    EXPECT_TRUE(fit.families[0].family->name == "catalan" || fit.families[0].family->name == "aldous");
    EXPECT_EQ(fit.families[3].family->name, "dst");
  }
  EXPECT_EQ(fits[1].name, trees[1].name);
}

TEST(FitTree, PooledLikelihoodsMultiply) {
  const auto trees = trees_of_model("bst", 200, 3);
  const auto families = chosen({"bst"});
  TreeFitOptions pooled;
  pooled.pooled = true;
  const auto all = fit_trees(trees, families, pooled, never);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].nodes, 600);
  double sum = 0;
  for (const TreeFit& fit : fit_trees(trees, families, {}, never)) sum += fit.families[0].log_likelihood;
  EXPECT_NEAR(all[0].families[0].log_likelihood, sum, 1e-9);
}

TEST(FitTree, RefusesTreesThatAreTooSmall) {
  const std::vector<RecordedTree> small{test::tree_of("((a,b),c);")};
  EXPECT_EQ(
      test::error_of([&] { fit_trees(small, chosen({"bst"}), {}, never); }),
      small[0].name +
          ": 2 internal nodes, 0 of which divide in more ways than one (bst needs 1 of them: trees of 3 "
          "internal nodes are the smallest that can be fitted): take a larger tree, or several pooled");
  const std::vector<RecordedTree> three{test::tree_of("(((a,b),c),d);")};
  EXPECT_EQ(test::error_of([&] { fit_trees(three, chosen({"aldous"}), {}, never); }), "");
  EXPECT_NE(test::error_of([&] { fit_trees(three, chosen({"beta"}), {}, never); }).find("trees of 4"),
            std::string::npos);
}

TEST(FitTree, BootstrapDoesNotDependOnThreads) {
  const auto trees = trees_of_model("bst", 60, 1);
  const auto with = [&](unsigned threads) {
    TreeFitOptions options;
    options.bootstrap = {20, 7};
    options.workforce = threads;
    return fit_trees(trees, chosen({"aldous", "beta_multinomial", "bst"}), options, never);
  };
  const auto one = with(1), three = with(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const FamilyFit &a = one[0].families[i], &b = three[0].families[i];
    EXPECT_EQ(a.goodness.p_value, b.goodness.p_value);
    EXPECT_EQ(a.goodness.trees, 20u);
    ASSERT_EQ(a.bootstrap.size(), a.parameters.size());
    for (std::size_t k = 0; k < a.bootstrap.size(); ++k) {
      EXPECT_EQ(a.bootstrap[k].lower, b.bootstrap[k].lower);
      EXPECT_EQ(a.bootstrap[k].bias, b.bootstrap[k].bias);
      EXPECT_LT(a.bootstrap[k].lower, a.bootstrap[k].upper);
    }
  }
}

TEST(FitTree, BootstrapStopsWhenAsked) {
  Cancellation stopped;
  stopped.request();
  TreeFitOptions options;
  options.bootstrap = {20, 7};
  EXPECT_THROW(fit_trees(trees_of_model("bst", 60, 1), chosen({"bst"}), options, stopped), Interrupted);
}

}  // namespace
}  // namespace ramify
