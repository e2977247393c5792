#include <functional>
#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/seed.hpp"
#include "support/wrong_laws.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify {
namespace {

using Read = double (*)(const TreeMeasures&);
using Grow = std::function<void(Size n, std::uint64_t trees, std::uint64_t seed, const test::Look& look)>;

/// @param law  of splits, or a model
template <class Law>
Grow grower_of(const Law& law) {
  return [law](Size n, std::uint64_t trees, std::uint64_t seed, const test::Look& look) {
    test::grow_and_measure(law, n, trees, seed, look);
  };
}

Grow grower_of_model(const std::string& model) {
  return grower_of(Model::parse(model));
}

test::SampleMean sample(const Grow& grow, Size n, std::uint64_t trees, const std::string& tag, Read read) {
  test::SampleMean mean;
  grow(n, trees, test::seed_of(tag), [&](const TreeMeasures& measures) { mean.add(read(measures)); });
  return mean;
}

double order(const TreeMeasures& m) {
  return m.strahler;
}
double depth(const TreeMeasures& m) {
  return m.depth;
}
double height(const TreeMeasures& m) {
  return m.height;
}
double fill(const TreeMeasures& m) {
  return m.fill_level;
}
double balance(const TreeMeasures& m) {
  return m.balance;
}

struct ExactMean {
  std::string name;
  std::string model;
  Size n;
  Read read;
  double exact;
  Grow wrong;  ///< the sampler of a near slip
  std::uint64_t trees = 6000;

  friend std::ostream& operator<<(std::ostream& out, const ExactMean& mean) { return out << mean.name; }
};

class KnownMeans : public ::testing::TestWithParam<ExactMean> {};

TEST_P(KnownMeans, AreReachedAndTellSlipsApart) {
  const auto& [name, model, n, read, exact, wrong, trees] = GetParam();
  EXPECT_TRUE(test::agrees(test::z_test(name, sample(grower_of_model(model), n, trees, name, read), exact)));
  EXPECT_TRUE(
      test::rejected(test::z_test(name + ", slip", sample(wrong, n, trees, name + ", slip", read), exact)));
}

// Exact means by dynamic programming over sizes and in closed form (A11, A13, A14, A15, B16), made apart
// from the library.
std::vector<ExactMean> exact_means() {
  const double p = 1 / 4.35;
  const Grow short_uniform = grower_of(test::ShortUniform{});
  const Grow short_catalan = grower_of(test::ShortCatalan{});
  const Grow short_patricia = grower_of(test::ShortPatricia{p});
  const Grow thesis_binomial = grower_of(test::ThesisBinomial{p});
  const Grow dst = grower_of(Dst(p)), patricia = grower_of(Patricia(p)), catalan = grower_of(Catalan());
  return {
      {"bst_3_order", "bst", 3, order, 4.0 / 3, catalan, 40000},
      {"bst_5_order", "bst", 5, order, 1.866667, short_uniform, 40000},
      {"bst_10_order", "bst", 10, order, 2.220265, catalan, 40000},
      {"bst_100_order", "bst", 100, order, 4.220366, short_uniform, 40000},
      {"bst_1000_order", "bst", 1000, order, 6.291212, short_uniform},
      {"bst_1000_depth", "bst", 1000, depth, 13.970942, short_uniform},
      {"bst_1000_height", "bst", 1000, height, 23.039506, short_uniform},
      {"bst_1000_fill", "bst", 1000, fill, 4.119673712785, short_uniform},
      {"bst_1000_balance", "bst", 1000, balance, 6.711966244376, short_uniform},
      {"catalan_10_order", "catalan", 10, order, 2.015956, short_catalan, 40000},
      {"catalan_100_order", "catalan", 100, order, 3.649242, short_catalan, 40000},
      {"catalan_1000_order", "catalan", 1000, order, 5.235551, short_catalan},
      {"catalan_1000_balance", "catalan", 1000, balance, 5.587713, short_catalan},
      {"patricia_10_order", "patricia(1/4.35)", 10, order, 2.104855, dst, 40000},
      {"patricia_579_order", "patricia(1/4.35)", 579, order, 5.029477, dst},
      {"patricia_579_order_n_strings", "patricia(1/4.35)", 579, order, 5.029477, short_patricia},
      {"patricia_2000_order", "patricia(1/4.35)", 2000, order, 6.004520, dst, 9000},
      {"dst_10_order", "dst(1/4.35)", 10, order, 2.179458, patricia, 40000},
      {"dst_579_order", "dst(1/4.35)", 579, order, 5.088462, patricia},
      {"dst_579_order_thesis", "dst(1/4.35)", 579, order, 5.088462, thesis_binomial},
      {"dst_579_balance", "dst(1/4.35)", 579, balance, 5.211026, patricia},
      {"dst_1000_order", "dst(1/4.35)", 1000, order, 5.760547, patricia},
      {"beta_4096_order", "beta(10,10)", 4096, order, 9.158269, grower_of(Beta(9, 9)), 2000},
      {"beta_multinomial_4096_order", "beta_multinomial(10,10)", 4096, order, 8.959290,
       grower_of(Beta(10, 10)), 2000},
  };
}

INSTANTIATE_TEST_SUITE_P(Issue, KnownMeans, ::testing::ValuesIn(exact_means()),
                         [](const auto& instance) { return instance.param.name; });

/// Means of every order's counts of streams, beside nodes.
struct SampledMeans {
  std::vector<test::SampleMean> streams;
  std::vector<test::SampleMean> nodes;
};

SampledMeans order_means(const std::string& model, Size n, std::size_t orders, std::uint64_t trees) {
  SampledMeans means{std::vector<test::SampleMean>(orders), std::vector<test::SampleMean>(orders)};
  grower_of_model(model)(n, trees, test::seed_of("counts of " + model), [&](const TreeMeasures& m) {
    for (std::size_t k = 0; k < orders; ++k) {
      means.streams[k].add(static_cast<double>(m.streams[k]));
      means.nodes[k].add(static_cast<double>(m.nodes[k]));
    }
  });
  return means;
}

void expect_stream_means(const std::string& model, Size n, std::uint64_t trees,
                         const std::vector<double>& exact) {
  const auto means = order_means(model, n, exact.size(), trees);
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const auto what = fmt::format("{}, n = {}, streams of order {}", model, n, k);
    EXPECT_TRUE(test::agrees(test::z_test(what, means.streams[k], exact[k])));
    if (k == 0) continue;  // leaves are both
    EXPECT_TRUE(test::rejected(test::z_test(what + ": nodes", means.nodes[k], exact[k])));
  }
}

TEST(ExactCounts, OfStreamsOfDsts) {
  expect_stream_means("dst(1/4.35)", 579, 80000, {580, 201.2269, 64.4826, 18.7627, 5.1268, 1.0895, 0.0885});
}

TEST(ExactCounts, OfStreamsOfBsts) {
  expect_stream_means("bst", 2, 1000, {3, 1});
  expect_stream_means("bst", 300, 10000, {301, 301.0 / 3});
}

TEST(ExactCounts, OfStreamsOfCatalanTrees) {
  expect_stream_means("catalan", 3, 10000, {4, 1.2});
  expect_stream_means("catalan", 1000, 5000, {1001, 250.375});
}

}  // namespace
}  // namespace ramify
