#include "ramify/large/order_grid.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/large/grid_series.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/split_rows.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

constexpr Size smallest_seam = 256;  // rows are compressed from 192 leaves on
constexpr double wide_step = 0.08;   // of the grid, at most log(2)/8
constexpr double narrow_step = 0.04;
constexpr double concentrated = 0.05;  // a deviation of split fractions below which laws swing with log n
constexpr double rare_order = 1e-9;

/// Earlier than that of LargeOrders, which aim at 1e-9: six standard deviations of a binomial split, not ten,
/// need lie within the tree.
Size seam_of(const Model& model) {
  return std::max(smallest_seam, static_cast<Size>(0.4 * smooth_from(model)));
}

/// Where splits are concentrated at a mean fraction: narrow, and so that the larger child lies at least
/// `clear_of_own` steps below its parent. Nearer, interpolation from smaller sizes alone amplifies what it
/// carries from step to step, and the means of high n are noise.
double concentrated_step(double fraction) {
  constexpr double clear_of_own = 2.5;
  return std::min(narrow_step, -std::log1p(-std::min(fraction, 1 - fraction)) / clear_of_own);
}

double step_of(const Model& model) {
  const SplitFraction fraction = model.character().fraction;
  if (const auto* constant = std::get_if<ConstantFraction>(&fraction)) return concentrated_step(constant->p);
  const auto* beta = std::get_if<BetaFraction>(&fraction);
  if (beta == nullptr || !beta->is_density()) return wide_step;
  const double sum = beta->a + beta->b, variance = beta->a * beta->b / (sum * sum * (sum + 1));
  return variance < concentrated * concentrated ? concentrated_step(beta->a / sum) : wide_step;
}

}  // namespace

ExactOrders::ExactOrders(const Model& model, Size n, const Cancellation& cancellation) : means(n) {
  StoredSplitRows rows(model);
  extend_law(means, rows, n, cancellation);
  moments.emplace(means, n);
  extend_law(*moments, rows, n, cancellation);
}

OrderMeansGrid::OrderMeansGrid(const Model& model, double leaves, const OrderMeans& exact,
                               const Cancellation& cancellation)
    : grid_(seam_of(model), step_of(model), leaves),
      rows_(model, step_of(model), leaves),
      strahler_(*Strahler::recurrence.rule, grid_, rows_, exact.strahler(), cancellation),
      means_(grid_, rows_, exact, strahler_, cancellation) {}

Size OrderMeansGrid::exact_to(const Model& model) {
  return seam_of(model) + residue_reach;  // room for what the residues of n need beside the seam
}

OrderGrid::OrderGrid(const Model& model, double leaves, const Cancellation& cancellation)
    : exact_(model, OrderMeansGrid::exact_to(model), cancellation),
      on_grid_(model, leaves, exact_.means, cancellation),
      moments_(on_grid_.grid(), on_grid_.rows(), *exact_.moments, on_grid_.strahler(), on_grid_.means(),
               cancellation) {}

std::vector<OrderOutcome> OrderGrid::orders(double leaves) const {
  const auto tail = strahler().tail(leaves - 1);
  const auto nodes = means().nodes(leaves), streams = means().streams(leaves);
  const auto reached = [&](std::size_t s) { return s < tail.size() ? std::clamp(tail[s], 0.0, 1.0) : 0; };
  std::vector<OrderOutcome> outcomes;
  for (std::size_t s = 0; s < tail.size(); ++s) {
    const double probability = reached(s) - reached(s + 1);
    if (probability < rare_order) continue;
    OrderOutcome& outcome = outcomes.emplace_back(OrderOutcome{s, probability, {}, {}});
    const auto given = [&](OrderCount count, double mean) {
      const double above = moments_.about_mean(leaves, count, s) - moments_.about_mean(leaves, count, s + 1);
      return std::max(mean + above / probability, 0.0);
    };
    for (std::size_t k = 1; k <= s; ++k) {
      outcome.nodes.push_back(given({OrderCount::Of::nodes, k}, nodes[k]));
      outcome.streams.push_back(given({OrderCount::Of::streams, k}, streams[k]));
    }
  }
  return outcomes;
}

}  // namespace ramify
