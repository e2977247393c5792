// Likelihood ratios of trees that were grown under the simpler of two nested families have the law that is
// known of them.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "ramify/fit/count_fit.hpp"
#include "ramify/fit/tree_bootstrap.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify::test {
namespace {

/// Two-sided, of `count` out of `trees` at a probability.
double binomial_p_value(std::uint64_t count, std::uint64_t trees, double probability) {
  const boost::math::binomial_distribution<> law(static_cast<double>(trees), probability);
  const auto x = static_cast<double>(count);
  return std::min(1.0, 2 * std::min(cdf(law, x), count == 0 ? 1.0 : cdf(complement(law, x - 1))));
}

std::uint64_t number_above(const std::vector<double>& ratios, double bound) {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(ratios, [bound](double ratio) { return ratio > bound; }));
}

/// Chi-square of one degree where the simpler family lies within the larger (Wilks 1938), 0 half of the time
/// and chi-square otherwise where it lies at its end (Chernoff 1954): 5 % are above 3.84 and 2.71.
void expect_law(const std::string& name, const std::vector<double>& ratios, bool at_end) {
  const auto check = [&](double bound, double probability, const std::string& what) {
    const std::uint64_t above = number_above(ratios, bound);
    return Goodness{name + what, static_cast<double>(above), 0,
                    binomial_p_value(above, ratios.size(), probability)};
  };
  EXPECT_TRUE(agrees(check(at_end ? 2.7055 : 3.8415, 0.05, ", 5 % point")));
  EXPECT_TRUE(agrees(check(1e-6, at_end ? 0.5 : 0.999, ", above 0")));
  EXPECT_TRUE(rejected(check(1e-6, at_end ? 0.999 : 0.5, ", above 0, the other law")));
}

/// A larger family with the simpler one beside it, neither fitted: what growing needs.
std::vector<FamilyFit> unfitted(const char* simpler, const char* larger) {
  std::vector<FamilyFit> fits{without_fit(find_family(simpler), 1), without_fit(find_family(larger), 1)};
  for (FamilyFit& fit : fits) fit.log_likelihood = 0;
  return fits;
}

TEST(NestedRatios, OfWholeTreesHaveTheirLaw) {
  const TreeBatch batch{Model::parse("bst"), 1000, seed_of("nested ratios"), 1, false};
  const ObservedSplits observed(batch.grown(0, 1, uninterrupted)[0].tree, "t");
  const BootstrapPlan plan{replicates(600), seed_of("nested ratios, trees")};
  for (const char* larger : {"aldous", "ford"}) {
    std::vector<FamilyFit> fits = unfitted("bst", larger);
    const auto ratios = grown_ratios(nested_pairs(fits)[0], observed, plan, 2, uninterrupted);
    expect_law(std::string("splits, bst in ") + larger, ratios, larger == std::string("ford"));
  }
}

TEST(NestedRatios, OfCountsHaveTheirLaw) {
  if (sanitized) GTEST_SKIP() << "OfWholeTreesHaveTheirLaw runs the same bootstrap";
  const ObservedCounts counts{{2001, 667, 220, 70, 22, 7, 2, 1}};
  CountFitter fitter(2, uninterrupted);
  const BootstrapPlan plan{replicates(600), seed_of("nested ratios, counts")};
  for (const auto& [simpler, larger] : {std::pair("bst", "aldous"), {"catalan", "ford"}, {"bst", "ford"}}) {
    std::vector<FamilyFit> fits = unfitted(simpler, larger);
    const auto ratios = fitter.grown_ratios(nested_pairs(fits)[0], counts, plan);
    const std::string name = std::string("counts, ") + simpler + " in " + larger;
    expect_law(name, ratios, name == "counts, bst in ford");
  }
}

}  // namespace
}  // namespace ramify::test
