// The z of counts that few trees have, where a normal law calls right samplers wrong: nodes of order 5 in
// uniform trees of 100 nodes, which one tree of 743 has, three or four of them.
#include "ramify/compare/clumped_count.hpp"

#include <cmath>
#include <cstdint>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/law/exact_means.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

constexpr Size rare_size = 100;
constexpr std::size_t rare_order = 5;

Moments exact_of(const StatisticInfo& statistic, double trees) {
  static const Model model = Model::parse("catalan");
  const ExactMeans laws(model, rare_size);
  const Moments one = laws.moments({statistic, {rare_order, 0}}, rare_size).value();
  return {trees * one.mean, trees * one.variance};
}

struct RareTotals {
  double nodes = 0, streams = 0;
};

/// Sums over so many uniform trees, the same ones for a seed and place.
class RareTrees {
 public:
  RareTotals next(std::uint64_t trees) {
    RareTotals totals;
    for (std::uint64_t i = 0; i < trees; ++i, ++replicate_) {
      sampler_->sample(rare_size, {test::seed_of("rare counts"), rare_size}, replicate_, measures_);
      if (measures_.strahler < rare_order) continue;
      totals.nodes += static_cast<double>(measures_.nodes[rare_order]);
      totals.streams += static_cast<double>(measures_.streams[rare_order]);
    }
    return totals;
  }

 private:
  std::unique_ptr<TreeSampler> sampler_ = make_tree_sampler(
      {Model::parse("catalan"), {orders_and_height, true}, rare_size, &test::uninterrupted});
  std::uint64_t replicate_ = 0;
  TreeMeasures measures_;
};

double two_sided(double z) {
  return 2 * cdf(complement(boost::math::normal(), std::abs(z)));
}

/// That so many of the samples or more go beyond z, where each does with the normal chance at most.
test::Goodness beyond(const std::string& what, double z, std::uint64_t samples, std::uint64_t seen) {
  const boost::math::binomial law(static_cast<double>(samples), two_sided(z));
  const double p = seen == 0 ? 1 : cdf(complement(law, static_cast<double>(seen) - 1));
  return {fmt::format("{}: {} of {} samples beyond {}", what, seen, samples, z), z, 0, p};
}

// 2,000 samples of 200 trees: 0.27 trees of each have such a node.
TEST(ClumpedCount, CallsARightSamplerWrongAsRarelyAsItSays) {
  constexpr std::uint64_t trees = 200;
  const std::uint64_t samples = test::replicates(2000);
  const Moments exact = exact_of(statistic::nodes, trees);
  constexpr double limit = 3.1;  // one in 500
  std::uint64_t clumped = 0, normal = 0;
  RareTrees grown;
  for (std::uint64_t i = 0; i < samples; ++i) {
    const double total = grown.next(trees).nodes;
    clumped += std::abs(clumped_count_z(total, exact.mean, exact.variance)) > limit ? 1 : 0;
    normal += std::abs(total - exact.mean) / std::sqrt(exact.variance) > limit ? 1 : 0;
  }
  EXPECT_TRUE(test::agrees(beyond("clumps", limit, samples, clumped)));
  EXPECT_TRUE(test::rejected(beyond("normal", limit, samples, normal)));
}

/// How surely the total of a wrong sampler goes beyond the z of alpha, by the law that it has: the chance of
/// the last total that does not.
double power_against(const Moments& claimed, const Moments& wrong) {
  const double limit = quantile(complement(boost::math::normal(), test::alpha / 2));
  const double step = wrong.mean > claimed.mean ? 1 : -1;
  double total = std::round(claimed.mean);
  while (std::abs(clumped_count_z(total + step, claimed.mean, claimed.variance)) <= limit) total += step;
  return cdf(boost::math::normal(), std::abs(clumped_count_z(total, wrong.mean, wrong.variance)));
}

// Nodes taken for streams, and streams for nodes.
TEST(ClumpedCount, CallsAWrongSamplerWrong) {
  constexpr std::uint64_t trees = 220'000;  // some 300 streams, near the largest there may be
  const Moments nodes = exact_of(statistic::nodes, trees), streams = exact_of(statistic::streams, trees);
  EXPECT_GT(power_against(nodes, streams), test::needed_power);
  EXPECT_GT(power_against(streams, nodes), test::needed_power);
  if (test::sanitized) GTEST_SKIP() << "fewer trees decide nothing";
  const RareTotals totals = RareTrees().next(trees);
  const auto tested = [](const char* what, double total, const Moments& exact) {
    const double z = clumped_count_z(total, exact.mean, exact.variance);
    return test::Goodness{what, z, 0, two_sided(z)};
  };
  EXPECT_TRUE(test::agrees(tested("nodes of order 5", totals.nodes, nodes)));
  EXPECT_TRUE(test::agrees(tested("streams of order 5", totals.streams, streams)));
  EXPECT_TRUE(test::rejected(tested("nodes of order 5, streams counted", totals.streams, nodes)));
  EXPECT_TRUE(test::rejected(tested("streams of order 5, nodes counted", totals.nodes, streams)));
}

}  // namespace
}  // namespace ramify
