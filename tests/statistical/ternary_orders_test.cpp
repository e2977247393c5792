// The exact stream counts of ternary trees of a thousand nodes against trees that are grown: two seconds,
// most of them binomial variates.
#include "ternary_orders.hpp"

#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/sample/tree_sampler.hpp"

namespace ramify {
namespace {

constexpr Size ternary_size = 1000;

/// Means of the stream counts, and of the squares of what they lie off the exact means.
struct GrownStreams {
  std::vector<test::SampleMean> counts, squares;
};

GrownStreams grown_streams(const Model& model, const StreamCounts& exact, std::size_t orders) {
  const auto sampler =
      make_tree_sampler({model, whole_trees(all_but_indices), ternary_size, &test::uninterrupted});
  GrownStreams grown{std::vector<test::SampleMean>(orders), std::vector<test::SampleMean>(orders)};
  TreeMeasures measures;
  for (std::uint64_t replicate = 0; replicate < test::replicates(2000); ++replicate) {
    sampler->sample(ternary_size, {test::seed_of("ternary streams"), model.stream_cell(ternary_size)},
                    replicate, measures);
    for (std::size_t k = 1; k < orders; ++k) {
      const double off = static_cast<double>(measures.streams[k]) - exact.means[k];
      grown.counts[k].add(off);
      grown.squares[k].add(off * off);
    }
  }
  return grown;
}

void expect_streams_of(const std::string& text, const std::string& nearest) {
  const Model model = Model::parse(text);
  const StreamCounts exact = ternary_stream_counts(model, ternary_size, test::uninterrupted);
  const StreamCounts wrong = ternary_stream_counts(Model::parse(nearest), ternary_size, test::uninterrupted);
  constexpr std::size_t orders = 5;
  const GrownStreams grown = grown_streams(model, exact, orders);
  for (std::size_t k = 1; k < orders; ++k) {
    const std::string what = fmt::format("{}, streams of order {}", text, k);
    EXPECT_TRUE(test::agrees(test::z_test(what, grown.counts[k], 0)));
    EXPECT_TRUE(test::agrees(test::z_test(what + ", variance", grown.squares[k], exact.covariance(k, k))));
    EXPECT_TRUE(test::rejected(
        test::z_test(what + ": " + nearest, grown.counts[k], wrong.means[k] - exact.means[k])));
  }
}

TEST(TernaryStreamCounts, OfTheWhiteFirAreThoseOfGrownTrees) {
  expect_streams_of("ternary(1/4.8)", "ternary(1/4.4)");
}

TEST(TernaryStreamCounts, OfTheMapleAreThoseOfGrownTrees) {
  expect_streams_of("node_ternary(size > 100 ? 1/3.19 : 1/(3.19+log(d)))",
                    "node_ternary(size > 100 ? 1/3.19 : 1/(3.19+log(d+1)))");
}

}  // namespace
}  // namespace ramify
