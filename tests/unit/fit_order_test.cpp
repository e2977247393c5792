// Families grown by order: their likelihood given the order of the root, fits to trees and to counts.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/error_of.hpp"
#include "support/seed.hpp"
#include "support/tree_files.hpp"
#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "ramify/fit/model_fits.hpp"
#include "ramify/fit/order_count_fit.hpp"
#include "ramify/fit/order_fit.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/theory/tokunaga_horton_ratio.hpp"

namespace ramify {
namespace {

std::vector<RecordedTree> trees_by_order(const char* model, Size order, std::uint64_t count) {
  return TreeBatch{Model::parse(model), order, test::seed_of("fit order"), 1, false}.grown(0, count, {});
}

ObservedBiOrders observed_of(const RecordedTree& tree) {
  return {tree.tree, tree.name};
}

/// The product over a tree's nodes of what the matrix says, node by node.
double literal_log_product(const RamificationMatrix& matrix, const Tree& tree) {
  std::vector<std::size_t> orders;
  double sum = 0;
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    if (tree.arity(node) == 0) {
      orders.push_back(0);
      continue;
    }
    const std::size_t one = orders.back();
    orders.pop_back();
    const std::size_t other = orders.back(), high = std::max(one, other), low = std::min(one, other);
    orders.back() = high == low ? high + 1 : high;
    sum += std::log(high == low ? matrix[high].back() : matrix[high - 1][low]);
  }
  return sum;
}

double minus_log_at(const Family& family, const ObservedBiOrders& observed, std::vector<double> values) {
  double value = std::nan("");
  EXPECT_TRUE(family.of_bi_orders(observed)(family.searched(values), value, nullptr));
  return value;
}

TEST(ObservedBiOrders, CountsNodesByTheOrdersBelow) {
  const ObservedBiOrders observed = observed_of(test::tree_of("((((a,b),c),d),((e,f),((g,h),(i,j))));"));
  ASSERT_EQ(observed.largest_order(), 2u);
  EXPECT_EQ(observed.count(1, 0), 2);  // (.., c) and (.., d)
  EXPECT_EQ(observed.count(1, 1), 4);
  EXPECT_EQ(observed.count(2, 0), 0);
  EXPECT_EQ(observed.count(2, 1), 2);  // (e,f) and ((a,b),..) beside ((g,h),(i,j))
  EXPECT_EQ(observed.count(2, 2), 1);
  EXPECT_EQ(observed.nodes(1), 6);
  EXPECT_EQ(observed.streams(1), 4);
  EXPECT_EQ(observed.all_nodes(), 9);
  EXPECT_EQ(observed.side_branches(1), 4);
  EXPECT_EQ(observed.side_branches(2), 0);
  ObservedBiOrders both = observed_of(test::tree_of("((a,b),c);"));
  both.add(observed);
  EXPECT_EQ(both.largest_order(), 2u);
  EXPECT_EQ(both.count(1, 0), 3);
  EXPECT_EQ(both.count(1, 1), 5);
  EXPECT_EQ(both.tree_orders().size(), 2u);
}

/// A table of what was counted in trees.
std::string table_of(const ObservedBiOrders& observed) {
  std::string text = "# counted\norder,side,count\n";
  for (std::size_t k = 1; k <= observed.largest_order(); ++k)
    for (std::size_t j = 0; j <= k; ++j)
      text += std::to_string(k + 1) + "," + std::to_string(j + 1) + "," +
              std::to_string(static_cast<int>(observed.count(k, j))) + "\n";
  return text;
}

ObservedBiOrders read_back(const std::string& text) {
  return ObservedBiOrders::of_table(CsvData::parse(text, "t.csv"));
}

TEST(ObservedBiOrders, ComeBackFromATable) {
  ObservedBiOrders observed = observed_of(trees_by_order("tokunaga(1,2)", 5, 1)[0]);
  for (const Size order : {3u, 4u, 3u})
    observed.add(observed_of(trees_by_order("tokunaga(1,2)", order, 1)[0]));
  EXPECT_TRUE(is_bi_order_table(table_of(observed)));
  EXPECT_FALSE(is_bi_order_table("order,count\n1,2\n"));
  EXPECT_FALSE(is_bi_order_table(""));
  const ObservedBiOrders back = read_back(table_of(observed));
  EXPECT_EQ(table_of(back), table_of(observed));
  EXPECT_EQ(std::vector<std::size_t>(back.tree_orders().begin(), back.tree_orders().end()),
            (std::vector<std::size_t>{5, 4, 3, 3}));
}

TEST(ObservedBiOrders, OfATableThatContradictsItselfAreRefused) {
  const std::array<std::array<const char*, 2>, 6> bad{
      {{"order,side,count\n2,2,5\n3,2,2\n3,3,2\n",
        "t.csv: 5 streams of the order 1 above the tips (6 of them are counted where they end"},
       {"order,side,count\n2,1,4\n", "no streams of the order 1"},
       {"order,side,count\n2,2,4\n2,2,1\n", "t.csv:3: p(2,2) again"},
       {"order,side,count\n2,3,1\n", "t.csv:2:3: side 3"},
       {"order,side,count\n2,2,1.5\n", "t.csv:2:5"},
       {"order,side,count\n2,2,2000001\n", "a table may have 1000000"}}};
  for (const auto& [text, says] : bad) {
    const std::string message = test::error_of([text = text] { read_back(text); });
    EXPECT_NE(message.find(says), std::string::npos) << message;
  }
}

TEST(ObservedBiOrders, RefusesForksOfThree) {
  EXPECT_NE(test::error_of([] { observed_of(test::tree_of("(a,b,c);")); }).find("a node with 3 children"),
            std::string::npos);
}

TEST(TokunagaLikelihood, IsTheProductOfTheForks) {
  const Family& family = find_family("tokunaga");
  const RecordedTree tree = trees_by_order("tokunaga(1,2)", 4, 1)[0];
  for (const auto& [a, c] : {std::array{1.0, 2.0}, {0.2, 3.0}, {5.0, 0.1}, {1e-3, 90.0}}) {
    const double literal = -literal_log_product(tokunaga_matrix(a, c), tree.tree);
    EXPECT_NEAR(minus_log_at(family, observed_of(tree), {a, c}), literal, 1e-11 * literal) << a << ' ' << c;
  }
}

TEST(TokunagaLikelihood, HasTheSlopesOfItsDifferences) {
  const Family& family = find_family("tokunaga");
  const SplitLikelihood likelihood =
      family.of_bi_orders(observed_of(trees_by_order("tokunaga(1,2)", 4, 1)[0]));
  for (const auto& at : {Point{0, 0.7}, {-2, 1}, {1.5, -3}, {-6, 4}}) {
    Point gradient(2);
    double value = 0, up = 0, down = 0;
    ASSERT_TRUE(likelihood(at, value, gradient.data()));
    for (std::size_t i = 0; i < 2; ++i) {
      Point more = at, less = at;
      more[i] += 1e-5;
      less[i] -= 1e-5;
      ASSERT_TRUE(likelihood(more, up, nullptr) && likelihood(less, down, nullptr));
      EXPECT_NEAR(gradient[i], (up - down) / 2e-5, 1e-6 * std::max(1.0, std::abs(value)));
    }
  }
}

TEST(FitGivenOrder, AMatrixIsItsSharesWithMultinomialErrors) {
  const RecordedTree tree = trees_by_order("tokunaga(1,2)", 4, 1)[0];
  const ObservedBiOrders observed = observed_of(tree);
  const FamilyFit fit = fit_given_order(find_family("ramification"), observed);
  ASSERT_EQ(fit.parameters.size(), 2u + 3u + 4u + 5u);
  EXPECT_EQ(fit.parameters.size() - fit.dependent, 10u);
  EXPECT_NEAR(fit.log_likelihood, literal_log_product(measured_matrix(observed), tree.tree),
              1e-11 * -fit.log_likelihood);
  EXPECT_NE(fit.note.find("fewer than 100 streams: p(k,k) is too large there"), std::string::npos)
      << fit.note;
  const FittedParameter& found = fit.parameters[3];
  const double x = observed.count(2, 1), nodes = observed.nodes(2), p = x / nodes;
  EXPECT_EQ(found.name, "p(2,1)");
  EXPECT_EQ(found.estimate, p);
  EXPECT_NEAR(found.standard_error, std::sqrt(p * (1 - p) / nodes), 1e-14);
  for (const double end : {found.lower, found.upper}) {
    const double lost = x * std::log(p / end) + (nodes - x) * std::log((1 - p) / (1 - end));
    EXPECT_NEAR(lost, 1.9207294103470627, 1e-6);
  }
}

/// A share of none is not known to be 0: (1-p)^nodes = e^-1.92 at the end.
TEST(FitGivenOrder, ASharesIntervalEndsWhereNoneWasSeen) {
  const ObservedBiOrders observed = observed_of(test::tree_of("((a,b),(c,(d,e)));"));
  const FamilyFit fit = fit_given_order(find_family("ramification"), observed);
  const FittedParameter& none = fit.parameters[2];
  EXPECT_EQ(none.name, "p(2,0)");
  EXPECT_EQ(none.estimate, 0);
  EXPECT_EQ(none.lower, 0);
  EXPECT_NEAR(none.upper, 1 - std::exp(-1.9207294103470627), 1e-9);
}

TEST(FitGivenOrder, TokunagaNumbersComeBack) {
  for (const auto& [model, a, c] : {std::tuple{"tokunaga(1,2)", 1.0, 2.0}, {"tokunaga(0.5,3)", 0.5, 3.0}}) {
    const FamilyFit fit =
        fit_given_order(find_family("tokunaga"), observed_of(trees_by_order(model, 6, 1)[0]));
    ASSERT_TRUE(fit.converged && !fit.at_end) << model;
    EXPECT_NEAR(fit.parameters[0].estimate, a, 4 * fit.parameters[0].standard_error) << model;
    EXPECT_NEAR(fit.parameters[1].estimate, c, 4 * fit.parameters[1].standard_error) << model;
    EXPECT_GT(fit.goodness.statistic, 0);
    EXPECT_EQ(fit.goodness.degrees, 19);
    ASSERT_TRUE(fit.horton_ratio) << model;
    EXPECT_NEAR(fit.horton_ratio->estimate, tokunaga_horton_ratio(a, c),
                4 * fit.horton_ratio->standard_error);
  }
}

TEST(FitGivenOrder, SaysWhichTreeIsTheSmallest) {
  const Family& family = find_family("tokunaga");
  const FamilyFit even = fit_given_order(family, observed_of(test::tree_of("((a,b),(c,d));")));
  EXPECT_TRUE(std::isnan(even.log_likelihood));
  EXPECT_NE(even.note.find("4 nodes at least"), std::string::npos) << even.note;
  const FamilyFit smallest = fit_given_order(family, observed_of(test::tree_of("(((a,b),x),(c,d));")));
  EXPECT_FALSE(std::isnan(smallest.log_likelihood)) << smallest.note;
}

TEST(FitGivenOrder, IsRankedApartFromWhatIsGivenTheSize) {
  const auto trees = trees_by_order("tokunaga(1,2)", 3, 1);
  ModelFitOptions options;
  options.families = chosen_families("bst,tokunaga,catalan,ramification", all_families());
  const auto data = fit_whole_trees(trees, "t", false, options, {});
  ASSERT_EQ(data.size(), 2u);
  EXPECT_EQ(data[0].given, Given::size);
  EXPECT_EQ(data[0].fits.size(), 2u);
  EXPECT_EQ(data[1].given, Given::order);
  EXPECT_EQ(data[1].fits.size(), 2u);
}

TEST(FitGivenOrder, BootstrapDoesNotDependOnThreads) {
  const auto trees = trees_by_order("tokunaga(1,2)", 3, 1);
  const std::vector<const Family*> both{&find_family("tokunaga"), &find_family("ramification")};
  const auto with = [&](unsigned threads) {
    TreeFitOptions options;
    options.bootstrap = {40, 7};
    options.workforce = threads;
    return fit_trees_given_order(trees, both, options, {})[0];
  };
  const TreeFit one = with(1), three = with(3);
  for (std::size_t f = 0; f < 2; ++f) {
    const FamilyFit &a = one.families[f], &b = three.families[f];
    ASSERT_EQ(a.bootstrap.size(), a.parameters.size());
    for (std::size_t i = 0; i < a.bootstrap.size(); ++i) {
      EXPECT_EQ(a.bootstrap[i].lower, b.bootstrap[i].lower);
      EXPECT_EQ(a.bootstrap[i].bias, b.bootstrap[i].bias);
    }
    const bool searched = a.family->name == "tokunaga";
    EXPECT_EQ(std::isnan(a.goodness.p_value), !searched);
    if (searched) {
      EXPECT_EQ(a.goodness.p_value, b.goodness.p_value);
    }
  }
}

const ObservedCounts walnut_streams{{1868, 596, 182, 50, 16, 6, 1}};

/// The definition: the Gaussian density of all that is new over that of the orders that are given.
double literal_minus_log(const ObservedCounts& counts, double a, double c) {
  const auto top = static_cast<Eigen::Index>(counts.top());
  const auto streams = [&](Eigen::Index k) {
    return static_cast<double>(counts.streams[static_cast<std::size_t>(k)]);
  };
  const auto side = [&](Eigen::Index i) { return a * std::pow(c, static_cast<double>(i) - 1); };
  Eigen::VectorXd fresh(top);
  Eigen::MatrixXd covariances = Eigen::MatrixXd::Identity(top, top) / 12;
  for (Eigen::Index k = 0; k < top; ++k) {
    fresh[k] = streams(k) - 2 * streams(k + 1);
    for (Eigen::Index j = k + 1; j <= top; ++j) fresh[k] -= side(j - k) * streams(j);
    for (Eigen::Index l = 0; l < top; ++l)
      for (Eigen::Index j = std::max(k, l) + 1; j <= top; ++j)
        covariances(k, l) += streams(j) * (side(j - k) * side(j - l) + (k == l ? side(j - k) : 0));
  }
  const auto density = [&](Eigen::Index first) -> double {
    const Eigen::Index size = top - first;
    const Eigen::MatrixXd part = covariances.bottomRightCorner(size, size);
    const Eigen::VectorXd off = fresh.tail(size);
    return (static_cast<double>(size) * std::log(2 * std::numbers::pi) + std::log(part.determinant()) +
            off.dot(part.inverse() * off)) /
           2;
  };
  return density(0) - density(static_cast<Eigen::Index>(orders_given_above(counts)));
}

TEST(OrderCounts, HaveTheDensityOfWhatIsNewAtEveryOrder) {
  const Family& family = tokunaga_by_ratio();
  EXPECT_EQ(orders_given_above(walnut_streams), 3u);
  const Objective objective = order_count_objective(walnut_streams);
  for (const auto& values : {std::vector{3.2, 0.4}, {4, 0.5}, {2.2, 0.9}, {8, 0.05}}) {
    const auto numbers = tokunaga_of_ratio(values);
    EXPECT_NEAR(tokunaga_horton_ratio(numbers[0], numbers[1]), values[0], 1e-12);
    const double literal = literal_minus_log(walnut_streams, numbers[0], numbers[1]);
    EXPECT_NEAR(objective.value(family.searched(values)), literal, 1e-8 * std::abs(literal));
  }
}

TEST(OrderCounts, HaveTheSlopesOfTheirDifferences) {
  const Family& family = tokunaga_by_ratio();
  const Objective objective = order_count_objective(walnut_streams);
  for (const auto& values : {std::vector{3.2, 0.4}, {4, 0.5}, {2.2, 0.9}, {8, 0.05}}) {
    const Point at = family.searched(values);
    Point gradient(2);
    double value = 0;
    ASSERT_TRUE(objective.evaluate(at, value, gradient.data()));
    for (std::size_t i = 0; i < 2; ++i) {
      Point up = at, down = at;
      up[i] += 1e-5;
      down[i] -= 1e-5;
      EXPECT_NEAR(gradient[i], (objective.value(up) - objective.value(down)) / 2e-5,
                  1e-6 * std::max(1.0, std::abs(value)));
    }
  }
}

TEST(OrderCounts, OfFewOrdersSayThatTheIntervalIsNarrow) {
  const FamilyFit few = fit_counts_given_order(walnut_streams);
  EXPECT_NE(few.note.find("fewer than 6 orders"), std::string::npos) << few.note;
  const FamilyFit enough = fit_counts_given_order({{262144, 65536, 16384, 4096, 1024, 256, 64, 16, 4, 1}});
  EXPECT_EQ(enough.note, "");
}

TEST(OrderCounts, OfTooFewStreamsSayWhatIsNeeded) {
  const FamilyFit fit = fit_counts_given_order({{40, 11, 2, 1}});
  EXPECT_TRUE(std::isnan(fit.log_likelihood));
  EXPECT_EQ(fit.note, "0 orders have an order above of 30 streams or more; 2 are needed");
}

TEST(TokunagaHortonRatio, IsWhereTheStreamsOfAllOrdersBalance) {
  EXPECT_NEAR(tokunaga_horton_ratio(1.0, 2.0), 4, 1e-14);  // the uniform tree
  for (const auto& [a, c] : {std::array{0.5, 3.0}, {2.0, 0.3}, {0.01, 5.0}}) {
    const double ratio = tokunaga_horton_ratio(a, c);
    EXPECT_NEAR(2 + a * ratio / (ratio - c), ratio, 1e-12 * ratio);  // 2 + sum of T_i R^(1-i)
  }
}

}  // namespace
}  // namespace ramify
