#include "ramify/large/stream_counts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/large/large_order_means.hpp"
#include "ramify/large/large_order_moments.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

constexpr Size smallest_seam = 512;  // rows are compressed from as many leaves on
constexpr double grid_step = 0.08;   // at most log(2)/8

/// Earlier than that of LargeOrders, which aim at 1e-9.
Size seam_of(const Model& model) {
  return std::max(smallest_seam, static_cast<Size>(smooth_from(model)));
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

StreamCounts exact_counts(const Model& model, Size n, const Cancellation& cancellation) {
  const OrderMeans means = build_law(model, n, OrderMeans(n), cancellation);
  const OrderMoments moments = build_law(model, n, OrderMoments(means, n), cancellation);
  const auto order_law = means.strahler().pmf(n);
  return collected(
      n, [&](OrderCount count) { return means.mean(n, count); },
      [&](OrderCount a, OrderCount b) { return moments.covariance(n, a, b); },
      [&](std::size_t s) {
        double above = 0;
        for (std::size_t order = order_law.size(); order-- > s;) above += order_law[order];
        return above;
      });
}

StreamCounts grid_counts(const Model& model, Size n, const Cancellation& cancellation) {
  const Size seam = seam_of(model);
  const double leaves = static_cast<double>(n) + 1;
  const SizeGrid grid(seam, grid_step, leaves);
  const CompressedRows rows(model, grid_step, leaves);
  const OrderMeans table = build_law(model, exact_to(model), OrderMeans(exact_to(model)), cancellation);
  const OrderMoments table_moments = build_law(model, seam, OrderMoments(table, seam), cancellation);
  const LargeJoin strahler(*Strahler::recurrence.rule, grid, rows, table.strahler(), cancellation);
  const LargeOrderMeans means(grid, rows, table, strahler, cancellation);
  const LargeOrderMoments moments(grid, rows, table_moments, strahler, means, cancellation);
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
