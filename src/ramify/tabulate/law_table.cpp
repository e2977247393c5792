#include "ramify/tabulate/law_table.hpp"

#include <fmt/format.h>

#include "ramify/law/balance_law.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/depth_law.hpp"
#include "ramify/law/fill_level_law.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/node_sum_law.hpp"
#include "ramify/law/order_moments.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {
namespace {

Row row_of(const LawRequest& request, Size n) {
  Row row;
  row.text(request.model.text()).whole(n);
  return row;
}

Table moments_table() {
  return Table({"model", "n", "statistic", "mean", "variance"});
}

template <class Law>
Table moments_table(const LawRequest& request, const Law& law) {
  Table table = moments_table();
  for (const Size n : request.sizes) {
    const auto [mean, variance] = law.moments(n);
    table.add(row_of(request, n).text(request.statistic).exact(mean).exact(variance));
  }
  return table;
}

template <class Law>
Table value_table(const LawRequest& request, const Law& law) {
  if (request.quantity == LawQuantity::moments) return moments_table(request, law);
  Table table({"model", "n", "statistic", "value", "probability"});
  for (const Size n : request.sizes) {
    Size value = law.lowest(n);
    for (const double probability : law.pmf(n)) {
      if (probability > 0)
        table.add(row_of(request, n).text(request.statistic).whole(value).exact(probability));
      ++value;
    }
  }
  return table;
}

Table mean_counts_table(const LawRequest& request, const OrderMeans& law) {
  Table table({"model", "n", "leaf_order", "order", "mean_nodes", "mean_streams"});
  for (const Size n : request.sizes) {
    const auto nodes = law.nodes(n), streams = law.streams(n);
    for (std::size_t k = 0; k <= HortonStrahler::largest_order(n); ++k)
      table.add(row_of(request, n).whole(0).whole(k).exact(nodes[k]).exact(streams[k]));
  }
  return table;
}

std::string name(const OrderCount& count) {
  return fmt::format("{}_{}", count.of == OrderCount::Of::nodes ? "nodes" : "streams", count.order);
}

/// Nodes, then streams, of the orders that a tree of size n can have.
std::vector<OrderCount> counts_of(Size n) {
  std::vector<OrderCount> counts;
  for (const auto of : {OrderCount::Of::nodes, OrderCount::Of::streams})
    for (std::size_t k = 0; k <= HortonStrahler::largest_order(n); ++k) counts.push_back({of, k});
  return counts;
}

Table count_moments_table(const LawRequest& request, const OrderMoments& law) {
  Table table = moments_table();
  for (const Size n : request.sizes)
    for (const OrderCount& count : counts_of(n))
      table.add(row_of(request, n).text(name(count)).exact(law.mean(n, count)).exact(law.variance(n, count)));
  return table;
}

Table covariance_table(const LawRequest& request, const OrderMoments& law) {
  Table table({"model", "n", "leaf_order", "first", "second", "covariance"});
  for (const Size n : request.sizes) {
    const auto counts = counts_of(n);
    for (auto first = counts.begin(); first != counts.end(); ++first)
      for (auto second = first; second != counts.end(); ++second)
        table.add(row_of(request, n)
                      .whole(0)
                      .text(name(*first))
                      .text(name(*second))
                      .exact(law.covariance(n, *first, *second)));
  }
  return table;
}

NodeSumLaw::Of sum_of(std::string_view statistic) {
  if (statistic == "path_length") return NodeSumLaw::Of::path_length;
  return statistic == "sackin" ? NodeSumLaw::Of::sackin : NodeSumLaw::Of::colless;
}

}  // namespace

Table law_table(const LawRequest& request, const Cancellation& cancellation) {
  const LawKind kind = request.kind();
  const Size largest = request.largest_size();
  const auto build = [&](auto law) {
    return build_law(request.model, largest, std::move(law), cancellation);
  };
  if (request.statistic == "strahler") return value_table(request, build(StrahlerLaw(largest)));
  if (request.statistic == "balance") return value_table(request, build(BalanceLaw(largest)));
  if (request.statistic == "fill_level") return value_table(request, build(FillLevelLaw(largest)));
  if (request.statistic == "height") return value_table(request, build(HeightLaw()));
  if (request.statistic == "depth") return value_table(request, build(DepthLaw()));
  if (request.statistic == "external_depth")
    return value_table(request, build(DepthLaw(DepthLaw::Of::external_node)));
  if (kind == LawKind::node_sum) return moments_table(request, build(NodeSumLaw(sum_of(request.statistic))));
  const OrderMeans means = build(OrderMeans(largest));
  if (kind == LawKind::order_means) return mean_counts_table(request, means);
  const OrderMoments moments = build(OrderMoments(means, largest));
  return request.quantity == LawQuantity::moments ? count_moments_table(request, moments)
                                                  : covariance_table(request, moments);
}

}  // namespace ramify
