// Do fits recover what trees were grown from? Of a thousand trees of known parameters: the bias of the
// estimate in its standard deviations, how many 95 % intervals hold the truth, how often the misfit is called
// small.

#include <cmath>
#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <boost/math/distributions/binomial.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/fit/count_fit.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/sample/grow_blocks.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify {
namespace {

constexpr std::uint64_t sets = 1000;
constexpr double most_bias = 0.2;  // of the estimate's standard deviation

/// A family, the truth, and what is known to fall short (docs/validation.md says so).
struct Recovery {
  const char* family;
  std::vector<double> truth;
  bool from_tree;
  Size n;
  bool is_biased = false;  ///< perhaps by more than most_bias: where few nodes say little of large parameters
  bool is_wide = false;    ///< intervals hold the truth more often than 95 %: next to a point of symmetry

  std::string name() const {
    std::string name = fmt::format("{}_{}_{}_{}", from_tree ? "tree" : "counts", family, truth.front(), n);
    for (char& c : name)
      if (c == '.' || c == '-') c = c == '.' ? 'p' : 'm';
    return name;
  }
};

std::vector<FamilyFit> fits_of_trees(const Recovery& of, const Family& family) {
  const TreeBatch batch{family.at(of.truth), of.n, test::seed_of("fit_recovery"), 2, false};
  const auto trees = batch.grown(0, sets, test::uninterrupted);
  const Family* only = &family;
  std::vector<FamilyFit> fits;
  for (TreeFit& tree : fit_trees(trees, std::span(&only, 1), {}, test::uninterrupted))
    fits.push_back(std::move(tree.families.front()));
  return fits;
}

std::vector<FamilyFit> fits_of_counts(const Recovery& of, const Family& family) {
  std::vector<ObservedCounts> counts(sets);
  const GrowingJob job{family.at(of.truth),       of.n, test::seed_of("fit_recovery"),
                       {orders_and_height, true}, 0,    sets};
  grow_blocks({job}, 2, test::uninterrupted, [&](const Block&, const BlockTrees& grown) {
    grown.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      counts[replicate].streams.assign(measures.streams.begin(),
                                       measures.streams.begin() + measures.strahler + 1);
    });
  });
  CountFitter fitter(2, test::uninterrupted);
  std::vector<FamilyFit> fits;
  for (const ObservedCounts& tree : counts) fits.push_back(fitter.fit(family, tree));
  return fits;
}

/// Two-sided: so many of the sets or a number as unlikely.
double binomial_p(std::uint64_t count, double probability) {
  const boost::math::binomial_distribution<> law(static_cast<double>(sets), probability);
  const auto x = static_cast<double>(count);
  return std::min(1.0, 2 * std::min(cdf(law, x), x < 1 ? 1.0 : cdf(complement(law, x - 1))));
}

class Recovered : public testing::TestWithParam<Recovery> {};

TEST_P(Recovered, WithinItsErrors) {
  const Recovery& of = GetParam();
  const Family& family = find_family(of.family);
  test::SampleMean estimates;
  double squares = 0;
  std::uint64_t covered = 0, converged = 0, small = 0;
  for (const FamilyFit& fit : of.from_tree ? fits_of_trees(of, family) : fits_of_counts(of, family)) {
    const FittedParameter& found = fit.parameters.front();
    converged += fit.converged ? 1 : 0;
    covered += found.lower <= of.truth[0] && of.truth[0] <= found.upper ? 1 : 0;
    small += fit.goodness.p_value <= 0.05 ? 1 : 0;
    estimates.add(found.estimate - of.truth[0]);
    squares += (found.estimate - of.truth[0]) * (found.estimate - of.truth[0]);
  }
  const double bias =
      estimates.mean() / std::sqrt(squares / static_cast<double>(sets) - std::pow(estimates.mean(), 2));
  fmt::print(
      "  {}: bias {:.3f} sd, covered {:.3f}, converged {}{}\n", of.name(), bias,
      static_cast<double>(covered) / sets, converged,
      of.from_tree ? "" : fmt::format(", misfit_p <= .05 in {:.3f}", static_cast<double>(small) / sets));
  EXPECT_EQ(converged, sets);
  if (!of.is_biased) {
    EXPECT_LT(std::abs(bias), most_bias);
  }
  if (of.is_wide) {
    EXPECT_GT(static_cast<double>(covered), 0.95 * sets);
    return;
  }
  const double p_value = binomial_p(covered, 0.95);
  EXPECT_TRUE(test::agrees({of.name() + ", coverage", static_cast<double>(covered), 0, p_value}));
  EXPECT_GT(p_value, 0.01 / 40) << "simultaneous at 1 % over the cases";
}

std::vector<Recovery> cases() {
  std::vector<Recovery> all;
  for (const bool from_tree : {true, false})
    for (const Size n : from_tree ? std::vector<Size>{60, 1000} : std::vector<Size>{579, 100'000}) {
      const bool is_small = n < 1000;
      all.push_back({"patricia", {0.23}, from_tree, n});
      all.push_back({"patricia", {0.1}, from_tree, n});
      all.push_back({"patricia", {0.45}, from_tree, n, false, is_small});
      all.push_back({"dst", {0.1}, from_tree, n});
      all.push_back({"dst", {0.3}, from_tree, n});
      all.push_back({"aldous", {0}, from_tree, n, from_tree && is_small});
      all.push_back({"aldous", {-1}, from_tree, n, from_tree && is_small});
      all.push_back({"aldous", {-1.5}, from_tree, n, from_tree && is_small});
      all.push_back({"ford", {0.3}, from_tree, n});
      all.push_back({"ford", {0.5}, from_tree, n});
    }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, Recovered, testing::ValuesIn(cases()),
                         [](const auto& instance) { return instance.param.name(); });

}  // namespace
}  // namespace ramify
