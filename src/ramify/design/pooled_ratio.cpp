#include "ramify/design/pooled_ratio.hpp"

#include "ramify/core/contract.hpp"
#include "ramify/large/large_orders.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/order_means.hpp"

namespace ramify {
namespace {

/// E M_1 + E M_2 + ...: summed from the top, the smallest first.
double streams_above_tips(const Model& model, Size n, const Cancellation& cancellation) {
  double sum = 0;
  if (n <= large_law_table(model)) {
    const auto means = build_law(model, n, OrderMeans(n), cancellation).streams(n);
    for (std::size_t k = means.size() - 1; k > 0; --k) sum += means[k];
    return sum;
  }
  const auto size = static_cast<double>(n);
  const auto means = LargeOrders(model, {size}, cancellation).means(size, OrderCount::Of::streams);
  for (std::size_t k = means.size() - 1; k > 0; --k) sum += means[k].value;
  return sum;
}

}  // namespace

double expected_pooled_ratio(const Model& model, Size n, const Cancellation& cancellation) {
  RAMIFY_EXPECTS(model.is_split() && n >= 1);
  const double above = streams_above_tips(model, n, cancellation);
  return (static_cast<double>(n) + above) / above;  // M_0 = n+1
}

}  // namespace ramify
