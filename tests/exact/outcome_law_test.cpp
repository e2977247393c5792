// The generic engine against all trees, weighed in rational numbers where the weights are rational, and
// against the recurrences made for one statistic each.

#include "ramify/law/outcome_law.hpp"

#include <array>
#include <map>
#include <vector>

#include "support/definitions.hpp"
#include "support/growing.hpp"
#include "support/sanitized.hpp"
#include "support/shape.hpp"
#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include "ramify/law/build_law.hpp"
#include "ramify/law/depth_law.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/sample/folds.hpp"

namespace ramify {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using EnumeratedFold = OrdersAndPathsOf<EnumeratedWalk>;

/// depth, height, order, fill level, balance, nodes of orders 1..3, streams of orders 1..3.
using Key = std::array<std::size_t, 11>;
using JointLaw = std::map<Key, double>;

template <class F>
auto laws_of(const Model& model, Size largest) {
  return outcome_laws(model, largest, [](ChoicePath& path) { return make_fold<F>(EnumeratedWalk(path)); });
}

// ---- all trees ----

Rational power(const Rational& base, Size exponent) {
  Rational product = 1;
  for (Size i = 0; i < exponent; ++i) product *= base;
  return product;
}

Rational binomial(Size n, Size k) {
  Rational product = 1;
  for (Size i = 1; i <= k; ++i) product = product * (n - k + i) / i;
  return product;
}

Rational catalan_number(Size n) {
  return binomial(2 * n, n) / (n + 1);
}

/// P(left = i), n >= 1.
using Weight = Rational (*)(Size n, Size i);

Rational bst_weight(Size n, Size) {
  return Rational(1) / n;
}
Rational catalan_weight(Size n, Size i) {
  return catalan_number(i) * catalan_number(n - 1 - i) / catalan_number(n);
}
Rational dst_weight(Size n, Size i) {
  const Rational p(1, 4);
  return binomial(n - 1, i) * power(p, i) * power(1 - p, n - 1 - i);
}
Rational patricia_weight(Size n, Size i) {
  const Rational p(1, 4);
  return binomial(n + 1, i + 1) * power(p, i + 1) * power(1 - p, n - i) /
         (1 - power(p, n + 1) - power(1 - p, n + 1));
}

Rational probability(const test::Shape& shape, Weight weight) {
  if (shape.is_external()) return 1;
  const auto &left = shape.children[0], &right = shape.children[1];
  return weight(test::internal_nodes(shape), test::internal_nodes(left)) * probability(left, weight) *
         probability(right, weight);
}

Key key_of(const test::Shape& shape) {
  auto nodes = test::nodes_per_order(shape), streams = test::streams_per_order(shape);
  nodes.resize(4);
  streams.resize(4);
  return {0,
          test::height(shape),
          test::strahler(shape),
          test::fill_level(shape),
          test::balance(shape),
          nodes[1],
          nodes[2],
          nodes[3],
          streams[1],
          streams[2],
          streams[3]};
}

JointLaw enumerate(Size n, Weight weight) {
  JointLaw law;
  for (const test::Shape& shape : test::all_shapes(n)) {
    const auto tree = static_cast<double>(probability(shape, weight));
    Key key = key_of(shape);
    for (const auto& [depth, share] : test::last_node_depth_law(shape)) {
      key[0] = depth;
      law[key] += tree * share;
    }
  }
  return law;
}

// ---- the engine ----

JointLaw joint_law(const OutcomesOf<EnumeratedFold>& outcomes) {
  JointLaw law;
  for (const auto& [value, tally, probability] : outcomes) {
    const auto& counts = std::get<2>(tally.parts);
    Key key{get<0>(value), get<1>(value), get<2>(value), get<3>(value), get<4>(value)};
    for (std::size_t k = 1; k <= 3; ++k) {
      key[4 + k] = counts.keep[k] + counts.begin[k];
      key[7 + k] = counts.begin[k];
    }
    law[key] += probability;
  }
  return law;
}

struct RationalModel {
  const char* model;
  Weight weight;

  friend std::ostream& operator<<(std::ostream& out, const RationalModel& rational) {
    return out << rational.model;
  }
};

class OutcomeLaw : public testing::TestWithParam<RationalModel> {};

TEST_P(OutcomeLaw, IsThatOfAllTrees) {
  constexpr Size largest = test::sanitized ? 8 : 10;
  const auto laws = laws_of<EnumeratedFold>(Model::parse(GetParam().model), largest);
  for (Size n = 0; n <= largest; ++n) {
    const JointLaw truth = enumerate(n, GetParam().weight), law = joint_law(laws[n]);
    ASSERT_EQ(law.size(), truth.size()) << "n = " << n;
    for (const auto& [key, probability] : truth) {
      ASSERT_TRUE(law.contains(key)) << "n = " << n;
      EXPECT_NEAR(law.at(key) / probability, 1, 1e-12) << "n = " << n;
    }
  }
}

TEST_P(OutcomeLaw, OfANeighbourIsAnother) {
  const Weight wrong = GetParam().weight == dst_weight ? patricia_weight : dst_weight;
  const JointLaw law = joint_law(laws_of<EnumeratedFold>(Model::parse(GetParam().model), 7)[7]);
  double distance = 0;
  for (const auto& [key, probability] : enumerate(7, wrong))
    distance += std::abs(probability - (law.contains(key) ? law.at(key) : 0)) / 2;
  EXPECT_GT(distance, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Exact, OutcomeLaw,
                         testing::Values(RationalModel{"bst", bst_weight},
                                         RationalModel{"catalan", catalan_weight},
                                         RationalModel{"dst(1/4)", dst_weight},
                                         RationalModel{"patricia(1/4)", patricia_weight}),
                         [](const auto& instance) { return std::string(instance.param.model).substr(0, 3); });

// ---- the special recurrences ----

/// The generic law of a fold without a tally, value by value, against a special law of the same statistic.
template <class F, class Law>
void expect_same(const Model& model, Size largest, Law empty) {
  const auto generic = laws_of<F>(model, largest);
  const Law special = build_law(model, largest, std::move(empty));
  for (Size n = 0; n <= largest; ++n) {
    const auto pmf = special.pmf(n);
    double covered = 0;
    for (const auto& [value, tally, probability] : generic[n]) {
      const std::size_t i = value - special.lowest(n);
      const double other = value >= special.lowest(n) && i < pmf.size() ? pmf[i] : 0;
      EXPECT_NEAR(probability, other, 1e-12) << model.text() << ", n = " << n << ", value " << +value;
      covered += other;
    }
    EXPECT_NEAR(covered, 1, 1e-12) << model.text() << ", n = " << n;
  }
}

class EngineOfModel : public testing::TestWithParam<std::string> {};

TEST_P(EngineOfModel, AgreesWithTheRecurrencesOfOneStatistic) {
  const Model model = Model::parse(GetParam());
  expect_same<Strahler>(model, 70, BoundedLaw(Strahler::recurrence, 70));
  expect_same<Balance>(model, 70, BoundedLaw(Balance::recurrence, 70));
  expect_same<FillLevel>(model, 70, BoundedLaw(FillLevel::recurrence, 70));
  expect_same<Height>(model, 50, HeightLaw());
  expect_same<LastNodeDepthOf<EnumeratedWalk>>(model, 40, DepthLaw(LastNodeDepth::recurrence));
}

TEST_P(EngineOfModel, AgreesWithTheMomentsOfTheCounts) {
  constexpr Size n = 20;
  const Model model = Model::parse(GetParam());
  const auto outcomes = laws_of<HortonStrahler>(model, n)[n];
  const auto means = build_law(model, n, OrderMeans(n));
  const auto moments = build_law(model, n, OrderMoments(means, n));
  using Of = OrderCount::Of;
  const auto count = [](const HortonStrahler::Tally& tally, OrderCount c) {
    const auto streams = tally.begin[c.order];
    return static_cast<double>(c.of == Of::streams ? streams : streams + tally.keep[c.order]);
  };
  const std::array<OrderCount, 5> counts{
      {{Of::nodes, 1}, {Of::nodes, 2}, {Of::streams, 1}, {Of::streams, 2}, {Of::streams, 3}}};
  for (const OrderCount a : counts) {
    for (const OrderCount b : counts) {
      double mean_a = 0, mean_b = 0, product = 0;
      for (const auto& [value, tally, probability] : outcomes) {
        mean_a += probability * count(tally, a);
        mean_b += probability * count(tally, b);
        product += probability * count(tally, a) * count(tally, b);
      }
      EXPECT_NEAR(moments.mean(n, a), mean_a, 1e-11);
      EXPECT_NEAR(moments.covariance(n, a, b), product - mean_a * mean_b, 1e-10);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Exact, EngineOfModel, testing::ValuesIn(test::all_models()));

}  // namespace
}  // namespace ramify
