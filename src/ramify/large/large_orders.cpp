#include "ramify/large/large_orders.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"
#include "ramify/large/large_order_means.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

constexpr double of_leaves = 1e-9;  // a mean count's error that needs no finer grid

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

  std::vector<double> means(double n, OrderCount::Of of) const {
    return of == OrderCount::Of::nodes ? means_.nodes(n + 1) : means_.streams(n + 1);
  }

 private:
  SizeGrid grid_;
  CompressedRows rows_;
  OrderMeans exact_;
  LargeJoin strahler_;
  LargeOrderMeans means_;
};

LargeOrders::LargeOrders(const Model& model, const std::vector<double>& sizes,
                         const Cancellation& cancellation) {
  RAMIFY_EXPECTS(!sizes.empty() && no_large_laws(model).empty());
  const double largest = *std::ranges::max_element(sizes);
  const auto solve = [&](Size seam, double step) {
    return std::make_unique<Solution>(model, seam, step, largest, cancellation);
  };
  const auto fine_enough = [&](const Refined<Solution>& solutions) {
    return std::ranges::all_of(sizes, [&](double n) {
      return std::ranges::all_of(means_of(solutions, n, OrderCount::Of::nodes),
                                 [n](const Estimate& mean) { return mean.error <= of_leaves * (n + 1); });
    });
  };
  solutions_ = std::make_unique<Refined<Solution>>(large_law_table(model), solve, fine_enough);
}

LargeOrders::LargeOrders(LargeOrders&&) noexcept = default;
LargeOrders& LargeOrders::operator=(LargeOrders&&) noexcept = default;
LargeOrders::~LargeOrders() = default;

std::vector<Estimate> LargeOrders::means_of(const Refined<Solution>& solutions, double n, OrderCount::Of of) {
  const auto fine = solutions.fine().means(n, of), coarse = solutions.coarse().means(n, of),
             early = solutions.early().means(n, of);
  std::vector<Estimate> means;
  for (std::size_t k = 0; k < fine.size(); ++k)
    means.push_back(Refined<Solution>::combined(fine[k], coarse[k], early[k]));
  return means;
}

std::vector<Estimate> LargeOrders::means(double n, OrderCount::Of of) const {
  return means_of(*solutions_, n, of);
}

}  // namespace ramify
