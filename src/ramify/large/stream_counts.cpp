#include "ramify/large/stream_counts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/large/order_grid.hpp"
#include "ramify/law/build_law.hpp"

namespace ramify {
namespace {

std::size_t top_order(Size n) {
  return static_cast<std::size_t>(std::log2(static_cast<double>(n) + 1));
}

OrderCount streams_of_order(std::size_t k) {
  return {OrderCount::Of::streams, k};
}

/// P(S >= s) of a law in reach of exact tables.
std::vector<double> exact_tail(const BoundedLaw& strahler, Size n) {
  std::vector<double> tail = strahler.pmf(n);
  tail.resize(top_order(n) + 2);
  for (std::size_t s = tail.size() - 1; s-- > 0;) tail[s] += tail[s + 1];
  return tail;
}

StreamMeans exact_means(const OrderMeans& exact, Size n) {
  StreamMeans counts;
  for (std::size_t k = 0; k <= top_order(n); ++k) counts.means.push_back(exact.mean(n, streams_of_order(k)));
  counts.order_tail = exact_tail(exact.strahler(), n);
  return counts;
}

StreamMeans grid_means(const LargeOrderMeans& means, const LargeJoin& strahler, Size n) {
  StreamMeans counts{means.streams(static_cast<double>(n) + 1), strahler.tail(static_cast<double>(n))};
  counts.means.resize(top_order(n) + 1);
  counts.order_tail.resize(top_order(n) + 2);
  for (double& above : counts.order_tail) above = std::clamp(above, 0.0, 1.0);
  return counts;
}

template <class CovarianceOf>
StreamCounts with_covariances(StreamMeans means, CovarianceOf covariance_of) {
  StreamCounts counts{std::move(means), {}};
  for (std::size_t j = 0; j < counts.orders(); ++j)
    for (std::size_t k = 0; k < counts.orders(); ++k)
      counts.covariances.push_back(covariance_of(streams_of_order(j), streams_of_order(k)));
  return counts;
}

StreamCounts exact_counts(const Model& model, Size n, const Cancellation& cancellation) {
  const ExactOrders exact(model, n, cancellation);
  return with_covariances(exact_means(exact.means, n),
                          [&](OrderCount a, OrderCount b) { return exact.moments->covariance(n, a, b); });
}

StreamCounts grid_counts(const Model& model, Size n, const Cancellation& cancellation) {
  const double leaves = static_cast<double>(n) + 1;
  const OrderGrid grid(model, leaves, cancellation);
  return with_covariances(grid_means(grid.means(), grid.strahler(), n), [&](OrderCount a, OrderCount b) {
    return grid.moments().covariance(leaves, a, b);
  });
}

bool is_exact(const Model& model, Size n) {
  return n <= OrderMeansGrid::exact_to(model);
}

void require_stream_counts(const Model& model, Size n) {
  if (const std::string reason = no_stream_counts(model, n); !reason.empty())
    throw Error(fmt::format("stream counts of {} at n = {}", model.text(), n), reason,
                "take another model, or a smaller n");
}

}  // namespace

double StreamCounts::deviation(std::span<const double> weights) const {
  RAMIFY_EXPECTS(weights.size() == orders());
  double variance = 0;
  for (std::size_t j = 0; j < orders(); ++j)
    for (std::size_t k = 0; k < orders(); ++k) variance += weights[j] * weights[k] * covariance(j, k);
  return std::sqrt(std::max(variance, 0.0));
}

double pooled_ratio_of_means(std::span<const double> means) {
  RAMIFY_EXPECTS(means.size() >= 2);
  double above = 0;  // from the top, the smallest first
  for (std::size_t k = means.size() - 1; k > 0; --k) above += means[k];
  return (means.front() - 1 + above) / above;
}

std::string no_stream_counts(const Model& model, Size n) {
  if (!model.is_split()) return "no law of its counts is known";
  if (is_exact(model, n)) return {};
  if (static_cast<double>(n) > largest_covariance_size) return "covariances of counts end at n = 1e15";
  return no_large_laws(model);
}

StreamCounts stream_counts(const Model& model, Size n, const Cancellation& cancellation) {
  require_stream_counts(model, n);
  return is_exact(model, n) ? exact_counts(model, n, cancellation) : grid_counts(model, n, cancellation);
}

StreamMeans stream_means(const Model& model, Size n, const Cancellation& cancellation) {
  require_stream_counts(model, n);
  const Size table = std::min(n, OrderMeansGrid::exact_to(model));
  const OrderMeans exact = build_law(model, table, OrderMeans(table), cancellation);
  if (is_exact(model, n)) return exact_means(exact, n);
  const OrderMeansGrid grid(model, static_cast<double>(n) + 1, exact, cancellation);
  return grid_means(grid.means(), grid.strahler(), n);
}

}  // namespace ramify
