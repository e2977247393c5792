#include "ramify/large/stream_counts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/large/large_order_means.hpp"
#include "ramify/large/large_order_moments.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/law/split_rows.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

constexpr Size smallest_seam = 256;  // rows are compressed from 192 leaves on
constexpr double wide_step = 0.08;   // of the grid, at most log(2)/8
constexpr double narrow_step = 0.04;
constexpr double concentrated = 0.05;  // a deviation of split fractions below which laws swing with log n

/// Earlier than that of LargeOrders, which aim at 1e-9: six standard deviations of a binomial split, not ten,
/// need lie within the tree.
Size seam_of(const Model& model) {
  return std::max(smallest_seam, static_cast<Size>(0.4 * smooth_from(model)));
}

double step_of(const Model& model) {
  const SplitFraction fraction = model.character().fraction;
  if (std::holds_alternative<ConstantFraction>(fraction)) return narrow_step;
  const auto* beta = std::get_if<BetaFraction>(&fraction);
  if (beta == nullptr || !beta->is_density()) return wide_step;
  const double sum = beta->a + beta->b, variance = beta->a * beta->b / (sum * sum * (sum + 1));
  return variance < concentrated * concentrated ? narrow_step : wide_step;
}

/// Room for what the residues of n need beside the seam.
Size exact_to(const Model& model) {
  return seam_of(model) + residue_reach;
}

std::size_t top_order(Size n) {
  return static_cast<std::size_t>(std::log2(static_cast<double>(n) + 1));
}

template <class MeanOf, class CovarianceOf, class TailOf>
StreamCounts collected(Size n, MeanOf mean_of, CovarianceOf covariance_of, TailOf tail_of) {
  const std::size_t orders = top_order(n) + 1;
  const auto streams = [](std::size_t k) { return OrderCount{OrderCount::Of::streams, k}; };
  StreamCounts counts;
  for (std::size_t j = 0; j < orders; ++j) {
    counts.means.push_back(mean_of(streams(j)));
    for (std::size_t k = 0; k < orders; ++k)
      counts.covariances.push_back(covariance_of(streams(j), streams(k)));
  }
  for (std::size_t s = 0; s <= orders; ++s) counts.order_tail.push_back(tail_of(s));
  return counts;
}

/// OrderMeans and OrderMoments to n: two passes over the same rows.
struct ExactOrders {
  ExactOrders(const Model& model, Size n, const Cancellation& cancellation) : means(n) {
    StoredSplitRows rows(model);
    extend_law(means, rows, n, cancellation);
    moments.emplace(means, n);
    extend_law(*moments, rows, n, cancellation);
  }
  ExactOrders(const ExactOrders&) = delete;  // the moments refer to the means
  ExactOrders& operator=(const ExactOrders&) = delete;
  ExactOrders(ExactOrders&&) = delete;
  ExactOrders& operator=(ExactOrders&&) = delete;
  ~ExactOrders() = default;

  OrderMeans means;
  std::optional<OrderMoments> moments;
};

StreamCounts exact_counts(const Model& model, Size n, const Cancellation& cancellation) {
  const ExactOrders exact(model, n, cancellation);
  const auto order_law = exact.means.strahler().pmf(n);
  return collected(
      n, [&](OrderCount count) { return exact.means.mean(n, count); },
      [&](OrderCount a, OrderCount b) { return exact.moments->covariance(n, a, b); },
      [&](std::size_t s) {
        double above = 0;
        for (std::size_t order = order_law.size(); order-- > s;) above += order_law[order];
        return above;
      });
}

StreamCounts grid_counts(const Model& model, Size n, const Cancellation& cancellation) {
  const double leaves = static_cast<double>(n) + 1, step = step_of(model);
  const SizeGrid grid(seam_of(model), step, leaves);
  const CompressedRows rows(model, step, leaves);
  const ExactOrders exact(model, exact_to(model), cancellation);
  const LargeJoin strahler(*Strahler::recurrence.rule, grid, rows, exact.means.strahler(), cancellation);
  const LargeOrderMeans means(grid, rows, exact.means, strahler, cancellation);
  const LargeOrderMoments moments(grid, rows, *exact.moments, strahler, means, cancellation);
  const auto streams = means.streams(leaves);
  const auto tail = strahler.tail(static_cast<double>(n));
  return collected(
      n, [&](OrderCount count) { return count.order < streams.size() ? streams[count.order] : 0; },
      [&](OrderCount a, OrderCount b) { return moments.covariance(leaves, a, b); },
      [&](std::size_t s) { return s < tail.size() ? std::clamp(tail[s], 0.0, 1.0) : 0; });
}

}  // namespace

std::string no_stream_counts(const Model& model, Size n) {
  if (!model.is_split()) return "no law of its counts is known";
  if (n <= exact_to(model)) return {};
  if (static_cast<double>(n) > largest_covariance_size) return "covariances of counts end at n = 1e15";
  return no_large_laws(model);
}

StreamCounts stream_counts(const Model& model, Size n, const Cancellation& cancellation) {
  if (const std::string reason = no_stream_counts(model, n); !reason.empty())
    throw Error(fmt::format("stream counts of {} at n = {}", model.text(), n), reason,
                "take another model, or a smaller n");
  return n <= exact_to(model) ? exact_counts(model, n, cancellation) : grid_counts(model, n, cancellation);
}

}  // namespace ramify
