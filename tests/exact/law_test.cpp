// The exact laws against published exact values and against all trees, weighed one by one.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "support/columns.hpp"
#include "support/definitions.hpp"
#include "support/growing.hpp"
#include "support/sanitized.hpp"
#include "support/shape.hpp"
#include <gtest/gtest.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/conditional_order_means.hpp"
#include "ramify/law/depth_law.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/law_limit.hpp"
#include "ramify/law/node_sum_law.hpp"
#include "ramify/law/order_means.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/external_depth.hpp"
#include "ramify/statistic/fill_level.hpp"
#include "ramify/statistic/registry.hpp"
#include "ramify/statistic/shape_indices.hpp"
#include "ramify/statistic/strahler.hpp"

namespace {

using ramify::ExactMeans;
using ramify::Model;
using ramify::Size;
namespace test = ramify::test;

// Thousands of terms are added one by one: their rounding must stay below the tolerance the laws are held to.
using Real = long double;
using Sums = std::vector<Real>;
using Pmf = std::function<std::vector<double>(Size)>;

Pmf pmf_of(const Model& model) {
  return [model](Size n) { return split_pmf(model, n); };
}

/// The product over the internal nodes of the probability of their split.
Real probability(const test::Shape& shape, const Pmf& pmf) {
  if (shape.is_external()) return 1;
  const auto &left = shape.children[0], &right = shape.children[1];
  const Real split = pmf(test::internal_nodes(shape))[test::internal_nodes(left)];
  return split * probability(left, pmf) * probability(right, pmf);
}

/// Laws and means over all trees of one size: tests/support has the definitions, nothing of law/ or
/// statistic/.
struct Enumerated {
  Sums strahler, height, fill_level, balance, depth;  // probabilities
  Sums nodes, streams;                                // means by order
};

Enumerated enumerate(Size n, const Pmf& pmf) {
  const Sums zeros(n + 3, 0);
  Enumerated sums{zeros, zeros, zeros, zeros, zeros, zeros, zeros};
  for (const test::Shape& shape : test::all_shapes(n)) {
    const Real p = probability(shape, pmf);
    sums.strahler[test::strahler(shape)] += p;
    sums.height[test::height(shape)] += p;
    sums.fill_level[test::fill_level(shape)] += p;
    sums.balance[test::balance(shape)] += p;
    for (const auto& [depth, share] : test::last_node_depth_law(shape)) sums.depth[depth] += p * share;
    const auto nodes = test::nodes_per_order(shape), streams = test::streams_per_order(shape);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      sums.nodes[k] += p * static_cast<Real>(nodes[k]);
      sums.streams[k] += p * static_cast<Real>(streams[k]);
    }
  }
  return sums;
}

ramify::Moments moments(const Sums& law) {
  Real mean = 0, square = 0;
  for (std::size_t k = 0; k < law.size(); ++k) {
    mean += static_cast<Real>(k) * law[k];
    square += static_cast<Real>(k * k) * law[k];
  }
  return {static_cast<double>(mean), static_cast<double>(square - mean * mean)};
}

double at(std::span<const double> values, std::size_t k) {
  return k < values.size() ? values[k] : 0.0;
}

void expect_near(double law, Real truth, double tolerance, const char* what) {
  EXPECT_NEAR(law, static_cast<double>(truth), tolerance) << what;
}

struct Laws {
  explicit Laws(const Model& model, Size n)
      : strahler(ramify::build_law(model, n, ramify::BoundedLaw(ramify::Strahler::recurrence, n))),
        balance(ramify::build_law(model, n, ramify::BoundedLaw(ramify::Balance::recurrence, n))),
        fill_level(ramify::build_law(model, n, ramify::BoundedLaw(ramify::FillLevel::recurrence, n))),
        height(ramify::build_law(model, n, ramify::HeightLaw())),
        depth(ramify::build_law(model, n, ramify::DepthLaw(ramify::LastNodeDepth::recurrence))),
        orders(ramify::build_law(model, n, ramify::OrderMeans(n))) {}

  ramify::BoundedLaw strahler;
  ramify::BoundedLaw balance;
  ramify::BoundedLaw fill_level;
  ramify::HeightLaw height;
  ramify::DepthLaw depth;
  ramify::OrderMeans orders;
};

class LawOfModel : public testing::TestWithParam<std::string> {};

TEST_P(LawOfModel, AgreesWithAllTreesToSize8) {
  constexpr double tolerance = 2e-14;
  const Model model = Model::parse(GetParam());
  const Pmf pmf = pmf_of(model);
  const Laws laws(model, 8);
  for (Size n = 0; n <= 8; ++n) {
    const Enumerated truth = enumerate(n, pmf);
    for (std::size_t k = 0; k < n + 3; ++k) {
      SCOPED_TRACE(testing::Message() << "n = " << n << ", value " << k);
      expect_near(at(laws.strahler.pmf(n), k), truth.strahler[k], tolerance, "strahler");
      expect_near(at(laws.balance.pmf(n), k), truth.balance[k], tolerance, "balance");
      expect_near(at(laws.fill_level.pmf(n), k), truth.fill_level[k], tolerance, "fill level");
      const Size lowest = laws.height.lowest(n);
      expect_near(k < lowest ? 0 : at(laws.height.pmf(n), k - lowest), truth.height[k], tolerance, "height");
      expect_near(at(laws.orders.nodes(n), k), truth.nodes[k], tolerance, "nodes");
      expect_near(at(laws.orders.streams(n), k), truth.streams[k], tolerance, "streams");
    }
    const auto check = [&](ramify::Moments law, const Sums& probabilities) {
      EXPECT_NEAR(law.mean, moments(probabilities).mean, 10 * tolerance) << "n = " << n;
      EXPECT_NEAR(law.variance, moments(probabilities).variance, 100 * tolerance) << "n = " << n;
    };
    check(laws.strahler.moments(n), truth.strahler);
    check(laws.balance.moments(n), truth.balance);
    check(laws.fill_level.moments(n), truth.fill_level);
    check(laws.height.moments(n), truth.height);
    check(laws.depth.moments(n), truth.depth);
  }
}

INSTANTIATE_TEST_SUITE_P(Exact, LawOfModel, testing::ValuesIn(ramify::test::all_models()));

// The neighbours that the enumeration must tell apart: dst for patricia, nodes for streams, balance for
// order.
TEST(Enumeration, TellsNeighboursApart) {
  constexpr Size n = 8;
  const Enumerated truth = enumerate(n, pmf_of(Model::parse("patricia(0.23)")));
  const Laws dst(Model::parse("dst(0.23)"), n);
  EXPECT_GT(std::abs(dst.strahler.moments(n).mean - moments(truth.strahler).mean), 0.01);
  EXPECT_GT(std::abs(dst.height.moments(n).mean - moments(truth.height).mean), 0.01);
  EXPECT_GT(std::abs(dst.depth.moments(n).mean - moments(truth.depth).mean), 0.01);
  EXPECT_GT(std::abs(static_cast<double>(truth.nodes[1] - truth.streams[1])), 0.01);
  EXPECT_GT(std::abs(moments(truth.balance).mean - moments(truth.strahler).mean), 0.01);
}

TEST(Laws, DoNotTellBetaWithOneMoreOnTheRightFromTheSymmetricBeta) {
  // (f(x) + f(1-x))/2 is the same for beta(a,a+1) and beta(a,a): so is every law that is blind to left and
  // right.
  constexpr Size n = 150;
  const ExactMeans skew(Model::parse("beta(2,3)"), n), even(Model::parse("beta(2,2)"), n);
  for (const char* column : {"strahler", "height", "depth", "fill_level", "balance", "nodes_2", "streams_3"})
    EXPECT_NEAR(skew.moments(test::column(column), n)->mean, even.moments(test::column(column), n)->mean,
                1e-11)
        << column;
  // They are near enough to each other that a third law is needed to show that the comparison can fail.
  const ExactMeans other(Model::parse("beta(2,4)"), n);
  EXPECT_GT(std::abs(other.moments(test::column("strahler"), n)->mean -
                     even.moments(test::column("strahler"), n)->mean),
            1e-3);
}

void expect_same_moments(const char* one, const char* other) {
  constexpr Size n = 300;
  const ExactMeans first(Model::parse(one), n), second(Model::parse(other), n);
  for (const char* column :
       {"strahler", "height", "depth", "fill_level", "balance", "nodes_2", "streams_3"}) {
    const auto law = *first.moments(test::column(column), n),
               truth = *second.moments(test::column(column), n);
    EXPECT_NEAR(law.mean, truth.mean, 1e-12 * truth.mean) << one << ' ' << column;
    EXPECT_NEAR(law.variance, truth.variance, 1e-10 * truth.variance) << one << ' ' << column;
  }
}

TEST(Laws, OfAldousTreesAreThoseOfTheBstAndOfCatalan) {
  expect_same_moments("aldous(0)", "bst");
  expect_same_moments("aldous(-3/2)", "catalan");
  expect_same_moments("ford(0)", "bst");
  expect_same_moments("ford(1/2)", "catalan");
  expect_same_moments("ford(1)", "chain");
}

/// In absolute terms.
void expect_moments_of_the_bst(const char* model, std::initializer_list<const char*> columns) {
  constexpr Size n = 300;
  const ExactMeans laws(Model::parse(model), n), bst(Model::parse("bst"), n);
  for (const char* name : columns) {
    const auto law = *laws.moments(test::column(name), n), truth = *bst.moments(test::column(name), n);
    EXPECT_NEAR(law.mean, truth.mean, 1e-12) << name;
    EXPECT_NEAR(law.variance, truth.variance, 1e-11) << name;
  }
}

TEST(Laws, OfBetaOneOneAreThoseOfTheBst) {
  expect_moments_of_the_bst("beta(1,1)", {"strahler", "height", "depth", "fill_level", "balance"});
}

TEST(Laws, OfBetaMultinomialOneOneAreThoseOfTheBst) {
  expect_moments_of_the_bst("beta_multinomial(1,1)",
                            {"strahler", "height", "depth", "fill_level", "balance", "nodes_2", "streams_3"});
}

TEST(OrderMeans, CountEveryNodeOnce) {
  for (const char* text : {"bst", "catalan", "patricia(0.23)"}) {
    const auto orders = ramify::build_law(Model::parse(text), 500, ramify::OrderMeans(500));
    double internal = 0;
    for (std::size_t k = 1; k < orders.nodes(500).size(); ++k) internal += orders.nodes(500)[k];
    EXPECT_NEAR(internal, 500, 1e-9) << text;
  }
}

TEST(HeightLaw, IsADistributionOnThePossibleHeights) {
  const auto law = ramify::build_law(Model::parse("catalan"), 200, ramify::HeightLaw());
  EXPECT_EQ(law.at_most(0, 0), 0);
  EXPECT_EQ(law.at_most(0, 1), 1);
  EXPECT_EQ(law.at_most(200, 8), 0);  // 200 internal nodes do not fit into 7 levels
  EXPECT_EQ(law.above(200, 201), 0);
  for (Size h = 0; h < 201; ++h) EXPECT_GE(law.above(200, h), law.above(200, h + 1)) << h;
}

TEST(ExactMeans, AnswersInAnyOrderAlike) {
  const Model model = Model::parse("patricia(0.3)");
  const ExactMeans down(model, 400), up(model, 300);
  for (const char* column :
       {"strahler", "height", "depth", "fill_level", "balance", "nodes_2", "streams_2"}) {
    down.moments(test::column(column), 400);
    const auto small = up.moments(test::column(column), 60);
    EXPECT_EQ(up.moments(test::column(column), 300)->mean, down.moments(test::column(column), 300)->mean)
        << column;
    EXPECT_EQ(small->mean, down.moments(test::column(column), 60)->mean) << column;
  }
}

TEST(ExactMeans, SaysWhatItDoesNotKnow) {
  const ExactMeans exact(Model::parse("bst"), 50);
  for (const char* column : {"nodes_mean_ratio", "width", "tokunaga_1"})
    EXPECT_FALSE(exact.moments(test::column(column), 20)) << column;
  EXPECT_FALSE(exact.moments(test::column("strahler"), 51));
  EXPECT_TRUE(exact.moments(test::column("strahler"), 50));
  EXPECT_EQ(exact.moments(test::column("nodes_9"), 20)->mean, 0);
  EXPECT_EQ(exact.moments(test::column("size"), 20)->mean, 20);
  EXPECT_EQ(exact.moments(test::column("size"), 20)->variance, 0);
  EXPECT_EQ(exact.moments(test::column("depth"), 0)->mean, 0);
  EXPECT_EQ(exact.moments(test::column("height"), 0)->mean, 1);
  EXPECT_EQ(exact.moments(test::column("external_depth"), 0)->mean, 1);
  EXPECT_EQ(exact.moments(test::column("magnitude"), 20)->mean, 21);
  EXPECT_NEAR(exact.moments(test::column("registers"), 20)->mean,
              exact.moments(test::column("strahler"), 20)->mean + 1, 1e-14);
  EXPECT_NEAR(exact.moments(test::column("sackin"), 20)->mean,
              21 * (exact.moments(test::column("external_depth"), 20)->mean - 1), 1e-12);
  EXPECT_NEAR(exact.moments(test::column("path_length"), 20)->mean + 40,
              exact.moments(test::column("sackin"), 20)->mean, 1e-12);
  EXPECT_NEAR(exact.moments(test::column("cherries"), 20)->mean, 7, 1e-13);
}

TEST(ExactMeans, HasVariancesOfCountsUpToTheirLimit) {
  if (ramify::test::sanitized) GTEST_SKIP() << "smaller sizes run the same code";
  const Model bst = Model::parse("bst");
  const Size limit = ramify::order_moments_limit(bst);
  ASSERT_LT(limit, ramify::law_limit(bst));
  const ExactMeans exact(bst, limit + 1);
  // Var M_1 = 2(n+1)/45 for n >= 4 (a classical result for cherries of Yule trees).
  EXPECT_NEAR(exact.moments(test::column("streams_1"), 20)->variance, 2.0 * 21 / 45, 1e-11);
  EXPECT_NEAR(exact.moments(test::column("streams_1"), limit)->variance,
              2.0 * static_cast<double>(limit + 1) / 45, 1e-9);
  EXPECT_TRUE(std::isnan(exact.moments(test::column("streams_1"), limit + 1)->variance));
  EXPECT_EQ(exact.moments(test::column("nodes_0"), 20)->variance, 0);
  EXPECT_EQ(exact.moments(test::column("nodes_9"), 20)->variance, 0);
  EXPECT_GE(exact.moments(test::column("nodes_1"), 1)->variance, 0);  // rounding must not leave it below
}

TEST(ExactMeans, StopsAtTheLimitOfItsModel) {
  const Model model = Model::parse("beta(2,2)");
  EXPECT_EQ(ExactMeans(model, 1'000'000).largest_n(), ramify::law_limit(model));
  EXPECT_FALSE(ExactMeans(model, 1'000'000).moments(test::column("size"), ramify::law_limit(model) + 1));
}

/// E[X_a X_b] - E X_a E X_b over all trees; counts are nodes 1..3, then streams 1..3.
std::vector<std::vector<Real>> enumerated_covariances(Size n, const Pmf& pmf) {
  constexpr std::size_t orders = 3, counts = 2 * orders;
  std::vector<Real> mean(counts, 0);
  std::vector<std::vector<Real>> product(counts, mean);
  for (const test::Shape& shape : test::all_shapes(n)) {
    const Real p = probability(shape, pmf);
    auto nodes = test::nodes_per_order(shape), streams = test::streams_per_order(shape);
    nodes.resize(orders + 1);
    streams.resize(orders + 1);
    std::vector<Real> x;
    for (std::size_t k = 1; k <= orders; ++k) x.push_back(static_cast<Real>(nodes[k]));
    for (std::size_t k = 1; k <= orders; ++k) x.push_back(static_cast<Real>(streams[k]));
    for (std::size_t a = 0; a < counts; ++a) {
      mean[a] += p * x[a];
      for (std::size_t b = 0; b < counts; ++b) product[a][b] += p * x[a] * x[b];
    }
  }
  for (std::size_t a = 0; a < counts; ++a)
    for (std::size_t b = 0; b < counts; ++b) product[a][b] -= mean[a] * mean[b];
  return product;
}

TEST(OrderMoments, AreThoseOfAllTrees) {
  using ramify::OrderCount;
  constexpr Size largest = 8;
  const auto count = [](std::size_t a) {
    return a < 3 ? OrderCount{OrderCount::Of::nodes, a + 1} : OrderCount{OrderCount::Of::streams, a - 2};
  };
  for (const char* text : {"bst", "catalan", "patricia(0.23)", "dst(0.4)", "beta(2,5)"}) {
    const Model model = Model::parse(text);
    const auto means = ramify::build_law(model, largest, ramify::OrderMeans(largest));
    const auto law = ramify::build_law(model, largest, ramify::OrderMoments(means, largest));
    for (Size n = 1; n <= largest; ++n) {
      const auto truth = enumerated_covariances(n, pmf_of(model));
      for (std::size_t a = 0; a < truth.size(); ++a)
        for (std::size_t b = 0; b < truth.size(); ++b)
          expect_near(law.covariance(n, count(a), count(b)), truth[a][b], 1e-12, text);
    }
  }
}

TEST(DepthLaw, OfAnExternalNodeIsThatOfAllTrees) {
  for (const char* text : {"bst", "catalan", "patricia(0.23)", "split(0.3)"}) {
    const Model model = Model::parse(text);
    const auto law = ramify::build_law(model, 8, ramify::DepthLaw(ramify::ExternalDepth::recurrence));
    for (Size n = 0; n <= 8; ++n) {
      Sums truth(n + 3, 0);
      for (const test::Shape& shape : test::all_shapes(n))
        for (const auto& [depth, share] : test::external_depth_law(shape))
          truth[depth] += probability(shape, pmf_of(model)) * share;
      for (std::size_t d = 0; d < truth.size(); ++d)
        expect_near(d < law.lowest(n) ? 0 : at(law.pmf(n), d - law.lowest(n)), truth[d], 2e-14, text);
    }
  }
}

/// A statistic that is a sum over the nodes, and its definition.
struct Additive {
  const char* column;
  double (*value)(const test::Shape&);
};

template <auto count>
double as_real(const test::Shape& shape) {
  return static_cast<double>(count(shape));
}

const std::vector<Additive> additive{{"path_length", as_real<test::path_length>},
                                     {"sackin", as_real<test::sackin>},
                                     {"colless", as_real<test::colless>},
                                     {"total_cophenetic", test::total_cophenetic},
                                     {"rooted_quartets", test::rooted_quartets},
                                     {"b2", test::b2},
                                     {"average_leaf_depth", test::average_leaf_depth},
                                     {"stairs1", test::stairs1},
                                     {"stairs2", test::stairs2},
                                     {"pitchforks", as_real<test::pitchforks>}};

TEST(NodeSumLaw, IsThatOfAllTrees) {
  for (const char* text : {"bst", "catalan", "patricia(0.23)", "beta(2,5)"}) {
    const Model model = Model::parse(text);
    const ExactMeans exact(model, 8);
    for (Size n = 1; n <= 8; ++n) {
      const auto shapes = test::all_shapes(n);
      Sums weights;
      for (const test::Shape& shape : shapes) weights.push_back(probability(shape, pmf_of(model)));
      for (const auto& [column, value_of] : additive) {
        Real mean = 0, square = 0;
        for (std::size_t i = 0; i < shapes.size(); ++i) {
          const Real value = value_of(shapes[i]);
          mean += weights[i] * value;
          square += weights[i] * value * value;
        }
        const ramify::Moments law = *exact.moments(test::column(column), n);
        expect_near(law.mean, mean, 1e-12, column);
        expect_near(law.variance, square - mean * mean, 1e-11 * static_cast<double>(1 + square), column);
      }
    }
  }
}

TEST(NodeSumLaw, IsOfEveryStatisticThatIsASum) {
  for (const ramify::StatisticInfo& info : ramify::statistics()) {
    if (!std::holds_alternative<ramify::NodeSum>(info.law.recurrence)) continue;
    EXPECT_TRUE(std::ranges::any_of(additive, [&](const auto& sum) { return info.name == sum.column; }))
        << info.name;
    if (info.toll != nullptr) {
      EXPECT_EQ(std::get<ramify::NodeSum>(info.law.recurrence).toll, info.toll) << info.name;
    }
  }
}

// m external nodes. Yule trees (bst): Mir, Rossello and Rotger 2013; Coronado et al. 2019; Rosenberg 2006
// (m/6 pitchforks, variance 23 m/420 from m = 7). Uniform trees (catalan): 3/5 C(m,4) by Coronado et al.
// 2019.
TEST(NodeSumLaw, HasThePublishedMeans) {
  constexpr Size n = 60;
  const double m = n + 1, quartets = m * (m - 1) * (m - 2) * (m - 3) / 24;
  double harmonic = 0;
  for (Size k = 1; k <= n + 1; ++k) harmonic += 1 / static_cast<double>(k);
  const ExactMeans yule(Model::parse("bst"), n), uniform(Model::parse("catalan"), n);
  const auto expect_mean = [](const ExactMeans& exact, const char* column, double mean) {
    EXPECT_NEAR(exact.moments(test::column(column), n)->mean / mean, 1, 1e-12) << column;
  };
  expect_mean(yule, "total_cophenetic", m * (m + 1) - 2 * m * harmonic);
  expect_mean(yule, "rooted_quartets", quartets);
  expect_mean(uniform, "rooted_quartets", 3 * quartets / 5);
  expect_mean(yule, "pitchforks", m / 6);
  EXPECT_NEAR(yule.moments(test::column("pitchforks"), n)->variance, 23 * m / 420, 1e-10);
  expect_mean(yule, "average_leaf_depth", 2 * (harmonic - 1));
}

// Of a BST (Knuth, TAOCP 6.2.2): E path length = 2 (n+1) H_n - 4n, variance 7n^2 - 4(n+1)^2 H2_n - 2(n+1) H_n
// + 13n.
TEST(NodeSumLaw, OfBstPathLengthsIsKnown) {
  const auto law = ramify::build_law(Model::parse("bst"), 1000,
                                     ramify::NodeSumLaw({ramify::ShapeIndices::path_length_toll}));
  Real harmonic = 0, squares = 0;
  for (Size n = 1; n <= 1000; ++n) {
    const Real size = static_cast<Real>(n);
    harmonic += 1 / size;
    squares += 1 / (size * size);
    expect_near(law.moments(n).mean, 2 * (size + 1) * harmonic - 4 * size, 1e-12 * static_cast<double>(n * n),
                "mean");
    expect_near(
        law.moments(n).variance,
        7 * size * size - 4 * (size + 1) * (size + 1) * squares - 2 * (size + 1) * harmonic + 13 * size,
        1e-11 * static_cast<double>(n * n), "variance");
  }
}

/// E[X_a | S = order] over all trees, X nodes 1..3, then streams 1..3; NaN where no tree has the order.
std::vector<Real> enumerated_means_given(Size n, std::size_t order, const Pmf& pmf) {
  constexpr std::size_t orders = 3;
  std::vector<Real> sum(2 * orders, 0);
  Real total = 0;
  for (const test::Shape& shape : test::all_shapes(n)) {
    auto nodes = test::nodes_per_order(shape), streams = test::streams_per_order(shape);
    if (nodes.size() != order + 1) continue;
    nodes.resize(orders + 1);
    streams.resize(orders + 1);
    const Real p = probability(shape, pmf);
    total += p;
    for (std::size_t k = 0; k < orders; ++k) {
      sum[k] += p * static_cast<Real>(nodes[k + 1]);
      sum[orders + k] += p * static_cast<Real>(streams[k + 1]);
    }
  }
  for (Real& mean : sum) mean /= total;
  return sum;
}

TEST(ConditionalOrderMeans, AreThoseOfAllTrees) {
  using ramify::OrderCount;
  constexpr Size largest = ramify::test::sanitized ? 6 : 8;
  for (const char* text : {"bst", "catalan", "patricia(0.23)", "dst(0.4)", "beta(2,5)"}) {
    const Model model = Model::parse(text);
    const auto means = ramify::build_law(model, largest, ramify::OrderMeans(largest));
    const auto law = ramify::build_law(model, largest, ramify::ConditionalOrderMeans(means, largest));
    for (Size n = 1; n <= largest; ++n)
      for (std::size_t order = 1; order <= 3; ++order) {
        const auto truth = enumerated_means_given(n, order, pmf_of(model));
        for (std::size_t k = 1; k <= 3; ++k) {
          const double nodes = law.mean(n, {OrderCount::Of::nodes, k}, order);
          const double streams = law.mean(n, {OrderCount::Of::streams, k}, order);
          if (std::isnan(truth[k - 1])) {
            EXPECT_TRUE(std::isnan(nodes) && std::isnan(streams)) << text << " " << n << " " << order;
          } else {
            expect_near(nodes, truth[k - 1], 1e-12, text);
            expect_near(streams, truth[k + 2], 1e-12, text);
          }
        }
      }
  }
}

// Var M_1 = 2(n+1)/45 for n >= 4 (a classical result for cherries of Yule trees).
TEST(OrderMoments, OfBstCherriesAreKnown) {
  const Model bst = Model::parse("bst");
  const auto means = ramify::build_law(bst, 300, ramify::OrderMeans(300));
  const auto law = ramify::build_law(bst, 300, ramify::OrderMoments(means, 300));
  const ramify::OrderCount cherries{ramify::OrderCount::Of::streams, 1};
  for (const Size n : {4u, 10u, 100u, 300u}) {
    EXPECT_NEAR(law.covariance(n, cherries, cherries), 2 * static_cast<double>(n + 1) / 45, 1e-11);
    EXPECT_NEAR(law.mean(n, cherries), static_cast<double>(n + 1) / 3, 1e-11);
  }
}

}  // namespace
