// Do fits of what is grown by order recover what trees were grown from, given the order of the root?

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "recovery.hpp"
#include "support/seed.hpp"
#include "support/uninterrupted.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/fit/order_count_fit.hpp"
#include "ramify/fit/order_fit.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/tabulate/tree_batch.hpp"
#include "ramify/theory/tokunaga_horton_ratio.hpp"

namespace ramify {
namespace {

constexpr std::uint64_t order_sets = 1000;
constexpr double unbiased_streams = 100;
constexpr double few_nodes = 5;     // of a share: below, its interval is too wide
constexpr double few_streams = 30;  // of an order: below, its row is not judged (docs/validation.md)

/// Trees of Tokunaga numbers with a root of that order.
struct ByOrder {
  double a, c;
  Size order;
  std::size_t orders_of_counts = 0;  ///< that carry a fit to counts, on the whole

  std::string name(const char* what) const {
    return test::case_name(fmt::format("{}_{}_{}_order{}", what, a, c, order));
  }
  Model model() const { return find_family("tokunaga").at(std::array{a, c}); }

  /// look(tree), one after the other.
  template <class Look>
  void each(std::uint64_t count, Look look) const {
    const TreeBatch batch{model(), order, test::seed_of("order_recovery"), 2, false};
    constexpr std::uint64_t chunk = 40;
    for (std::uint64_t first = 0; first < count; first += chunk)
      for (const RecordedTree& tree : batch.grown(first, std::min(first + chunk, count), test::uninterrupted))
        look(tree);
  }
};

class RecoveredByOrder : public testing::TestWithParam<ByOrder> {};

TEST_P(RecoveredByOrder, TokunagaOfTrees) {
  const ByOrder& of = GetParam();
  test::RecoveredNumber a(of.a), c(of.c);
  std::uint64_t without = 0;
  of.each(order_sets, [&](const RecordedTree& tree) {
    const FamilyFit fit = fit_given_order(find_family("tokunaga"), ObservedBiOrders(tree.tree, tree.name));
    if (fit.parameters.empty() || !fit.converged) {
      ++without;
      return;
    }
    a.add(fit.parameters[0]);
    c.add(fit.parameters[1]);
  });
  a.expect(of.name("tokunaga_a"), {}, fmt::format(", {} not fitted", without));
  c.expect(of.name("tokunaga_c"), {});
}

/// The shares of the nodes of order k, if it has streams enough to judge; p(k,k) is biased where they are
/// few.
void expect_row(const std::string& name, const std::vector<double>& truth, double streams,
                const std::vector<test::RecoveredNumber>& shares) {
  const std::size_t k = truth.size() - 1;
  double bias = 0, least = 1, most = 0;
  for (std::size_t j = 0; j <= k; ++j) {
    if (streams >= few_streams && streams * truth[j] >= few_nodes * truth[k])
      shares[j].expect(fmt::format("{}_p{}{}", name, k, j), {j == k && streams < unbiased_streams});
    if (j < k) bias = std::max(bias, std::abs(shares[j].bias()));
    least = std::min(least, shares[j].covered());
    most = std::max(most, shares[j].covered());
  }
  fmt::print(
      "  {}, row {}: {:.0f} streams, bias to {:.3f} sd, of p(k,k) {:.3f} sd, covered {:.3f} to {:.3f}\n",
      name, k, streams, bias, shares[k].bias(), least, most);
}

TEST_P(RecoveredByOrder, MatrixOfTrees) {
  const ByOrder& of = GetParam();
  const RamificationMatrix truth = tokunaga_matrix(of.a, of.c);
  std::vector<std::vector<test::RecoveredNumber>> shares;
  std::vector<double> streams(of.order, 0.0);
  for (std::size_t k = 1; k <= of.order; ++k) shares.emplace_back(truth[k - 1].begin(), truth[k - 1].end());
  of.each(order_sets, [&](const RecordedTree& tree) {
    const ObservedBiOrders observed(tree.tree, tree.name);
    const FamilyFit fit = fit_given_order(find_family("ramification"), observed);
    std::size_t i = 0;
    for (std::size_t k = 1; k <= of.order; ++k) {
      streams[k - 1] += observed.streams(k) / static_cast<double>(order_sets);
      for (auto& share : shares[k - 1]) share.add(fit.parameters[i++]);
    }
  });
  for (std::size_t k = 1; k <= of.order; ++k)
    expect_row(of.name("matrix"), truth[k - 1], streams[k - 1], shares[k - 1]);
}

TEST_P(RecoveredByOrder, RatioOfCounts) {
  const ByOrder& of = GetParam();
  test::RecoveredNumber ratio(tokunaga_horton_ratio(of.a, of.c));
  std::uint64_t without = 0, small = 0, fitted = 0;
  of.each(order_sets, [&](const RecordedTree& tree) {
    const FamilyFit fit = fit_counts_given_order({measure_orders(tree).streams});
    if (fit.parameters.empty() || !fit.converged) {
      ++without;
      return;
    }
    ++fitted;
    small += fit.goodness.p_value <= 0.05 ? 1 : 0;
    ratio.add(fit.parameters[0]);
  });
  const bool has_few = of.orders_of_counts < 6;  // the program says so
  const test::Shortfall shortfall{has_few, false, has_few ? 0.88 : 0.95};
  if (fitted > 0)
    ratio.expect(of.name("counts_ratio"), shortfall,
                 fmt::format(", {} not fitted, misfit_p <= .05 in {:.3f}", without,
                             static_cast<double>(small) / static_cast<double>(fitted)));
}

/// Shares of trees whose p-value as trees of Tokunaga numbers is at most each level.
constexpr std::array goodness_levels{0.01, 0.05, 0.1};
std::array<double, 3> called_small(std::span<const RecordedTree> trees) {
  const Family* const family = &find_family("tokunaga");
  std::array<double, 3> found{};
  for (const RecordedTree& tree : trees) {
    TreeFitOptions options;
    options.bootstrap = {99, test::seed_of(tree.name)};
    options.workforce = 2;
    const auto fits = fit_trees_given_order({&tree, 1}, {&family, 1}, options, test::uninterrupted);
    for (std::size_t i = 0; i < found.size(); ++i)
      if (fits[0].families[0].goodness.p_value <= goodness_levels[i])
        found[i] += 1 / static_cast<double>(trees.size());
  }
  return found;
}

/// Randomised p-values of the right family are uniform; those of BSTs, whose side branches fall faster than
/// any c^k, are small.
TEST(RecoveredGoodness, OfTokunagaNumbers) {
  const TreeBatch right{find_family("tokunaga").at(std::array{1.0, 2.0}), 6, test::seed_of("order_goodness"),
                        2, false};
  const TreeBatch wrong{find_family("bst").at({}), 10'000, test::seed_of("order_goodness"), 2, false};
  const auto of_right = called_small(right.grown(0, 200, test::uninterrupted));
  const auto of_wrong = called_small(wrong.grown(0, 20, test::uninterrupted));
  for (std::size_t i = 0; i < goodness_levels.size(); ++i) {
    const double level = goodness_levels[i];
    fmt::print("  tokunaga(1,2), order 6: P(p <= {}) = {:.3f}; bst, n = 10^4: {:.3f}\n", level, of_right[i],
               of_wrong[i]);
    EXPECT_NEAR(of_right[i], level, 4 * std::sqrt(level * (1 - level) / 200));
  }
  EXPECT_GT(of_wrong[1], 0.5);
}

std::vector<ByOrder> order_cases() {
  std::vector<ByOrder> all;
  for (const Size order : {6u, 9u}) {
    all.push_back({1, 2, order, order - 3});
    all.push_back({0.5, 3, order, order - 3});
    all.push_back({0.3, 0.5, order, order - 5});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, RecoveredByOrder, testing::ValuesIn(order_cases()),
                         [](const auto& instance) { return instance.param.name("tokunaga"); });

}  // namespace
}  // namespace ramify
