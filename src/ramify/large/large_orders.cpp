#include "ramify/large/large_orders.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/large/large_order_means.hpp"
#include "ramify/large/large_order_moments.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

constexpr double of_leaves = 1e-9;             // a mean count's error that needs no finer grid
constexpr double covariance_of_leaves = 5e-8;  // the same of a covariance
constexpr int halvings_of_covariances = 2;     // at most; a third takes a minute to 1e12

}  // namespace

/// One computation, from one seam on one grid.
class LargeOrders::Solution {
 public:
  Solution(const Model& model, Size table, double step, double largest_n, const Cancellation& cancellation)
      : grid_(table, step, largest_n + 1),
        rows_(model, step, largest_n + 1),
        exact_(build_law(model, table + residue_reach, OrderMeans(table + residue_reach), cancellation)),
        strahler_(*Strahler::recurrence.rule, grid_, rows_, exact_.strahler(), cancellation),
        means_(grid_, rows_, exact_, strahler_, cancellation) {}
  Solution(const Solution&) = delete;  // the computations refer to each other
  Solution& operator=(const Solution&) = delete;
  Solution(Solution&&) = delete;
  Solution& operator=(Solution&&) = delete;
  ~Solution() = default;

  void solve_moments(const OrderMoments& table, const Cancellation& cancellation) {
    moments_.emplace(grid_, rows_, table, strahler_, means_, cancellation);
  }

  std::vector<double> means(double n, OrderCount::Of of) const {
    return of == OrderCount::Of::nodes ? means_.nodes(n + 1) : means_.streams(n + 1);
  }

  double covariance(double n, OrderCount a, OrderCount b) const { return moments_->covariance(n + 1, a, b); }

 private:
  SizeGrid grid_;
  CompressedRows rows_;
  OrderMeans exact_;
  LargeJoin strahler_;
  LargeOrderMeans means_;
  std::optional<LargeOrderMoments> moments_;
};

LargeOrders::LargeOrders(const Model& model, const std::vector<double>& sizes,
                         const Cancellation& cancellation)
    : model_(model), sizes_(sizes) {
  RAMIFY_EXPECTS(!sizes.empty() && no_large_laws(model).empty());
  const double largest = *std::ranges::max_element(sizes);
  const auto solve = [&](Size seam, double step) {
    return std::make_unique<Solution>(model, seam, step, largest, cancellation);
  };
  const auto fine_enough = [&](const Refined<Solution>& solutions) {
    return std::ranges::all_of(sizes, [&](double n) {
      return std::ranges::all_of(
          means_of(solutions, n, OrderCount::Of::nodes),
          [n](const Approximation& mean) { return mean.error <= of_leaves * (n + 1); });
    });
  };
  solutions_ = std::make_unique<Refined<Solution>>(large_law_table(model), solve, fine_enough);
}

LargeOrders::LargeOrders(LargeOrders&&) noexcept = default;
LargeOrders& LargeOrders::operator=(LargeOrders&&) noexcept = default;
LargeOrders::~LargeOrders() = default;

std::vector<Approximation> LargeOrders::means_of(const Refined<Solution>& solutions, double n,
                                                 OrderCount::Of of) {
  const auto fine = solutions.fine().means(n, of), coarse = solutions.coarse().means(n, of),
             early = solutions.early().means(n, of);
  std::vector<Approximation> means;
  for (std::size_t k = 0; k < fine.size(); ++k)
    means.push_back(Refined<Solution>::combined(fine[k], coarse[k], early[k]));
  return means;
}

std::vector<Approximation> LargeOrders::means(double n, OrderCount::Of of) const {
  return means_of(*solutions_, n, of);
}

void LargeOrders::solve_covariances(const Cancellation& cancellation) {
  std::vector<double> sizes;
  std::ranges::copy_if(sizes_, std::back_inserter(sizes),
                       [](double n) { return n <= largest_covariance_size; });
  RAMIFY_EXPECTS(!sizes.empty());
  const double largest = *std::ranges::max_element(sizes);
  const Size seam = large_law_table(model_);
  const OrderMeans means = build_law(model_, seam, OrderMeans(seam), cancellation);
  const OrderMoments table = build_law(model_, seam, OrderMoments(means, seam), cancellation);
  const auto solve = [&](Size from, double step) {
    auto solution = std::make_unique<Solution>(model_, from, step, largest, cancellation);
    solution->solve_moments(table, cancellation);
    return solution;
  };
  const auto fine_enough = [&sizes, halved = 0](const Refined<Solution>& solutions) mutable {
    return halved++ == halvings_of_covariances ||
           std::ranges::all_of(sizes, [&](double n) { return covariances_are_good(solutions, n); });
  };
  with_covariances_ = std::make_unique<Refined<Solution>>(seam, solve, fine_enough);
}

Approximation LargeOrders::covariance_of(const Refined<Solution>& solutions, double n, OrderCount a,
                                         OrderCount b) {
  return Refined<Solution>::combined(solutions.fine().covariance(n, a, b),
                                     solutions.coarse().covariance(n, a, b),
                                     solutions.early().covariance(n, a, b));
}

bool LargeOrders::covariances_are_good(const Refined<Solution>& solutions, double n) {
  const auto orders = static_cast<std::size_t>(std::log2(n + 1));
  for (std::size_t a = 1; a <= orders; ++a)
    for (std::size_t b = 1; b <= orders; ++b)
      for (const auto of_a : {OrderCount::Of::nodes, OrderCount::Of::streams})
        for (const auto of_b : {OrderCount::Of::nodes, OrderCount::Of::streams})
          if (covariance_of(solutions, n, {of_a, a}, {of_b, b}).error > covariance_of_leaves * (n + 1))
            return false;
  return true;
}

Approximation LargeOrders::covariance(double n, OrderCount a, OrderCount b,
                                      const Cancellation& cancellation) {
  if (n > largest_covariance_size)
    throw Error("covariances of trees of n = " + format_exact(n), "they are computed to n = 1e15",
                "ask for a smaller n, or for the means alone");
  if (with_covariances_ == nullptr) solve_covariances(cancellation);
  return covariance_of(*with_covariances_, n, a, b);
}

Approximation LargeOrders::variance(double n, OrderCount count, const Cancellation& cancellation) {
  Approximation variance = covariance(n, count, count, cancellation);
  variance.value = std::max(0.0, variance.value);
  return variance;
}

}  // namespace ramify
