#include "ramify/design/pooled_ratio.hpp"

#include <vector>

#include "ramify/core/contract.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/large/stream_counts.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/order_means.hpp"

namespace ramify {
namespace {

/// E M_0, E M_1, ..., as exactly as they are known (stream_means is coarser, and faster).
std::vector<double> expected_streams(const Model& model, Size n, const Cancellation& cancellation) {
  if (n <= large_law_table(model)) return build_law(model, n, OrderMeans(n), cancellation).streams(n);
  const auto size = static_cast<double>(n);
  std::vector<double> means;
  for (const Approximation& mean :
       LargeOrders(model, {size}, cancellation).means(size, OrderCount::Of::streams))
    means.push_back(mean.value);
  return means;
}

}  // namespace

double expected_pooled_ratio(const Model& model, Size n, const Cancellation& cancellation) {
  RAMIFY_EXPECTS(model.is_split() && n >= 1);
  return pooled_ratio_of_means(expected_streams(model, n, cancellation));
}

}  // namespace ramify
