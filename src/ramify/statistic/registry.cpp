#include "ramify/statistic/registry.hpp"

#include <iterator>

#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/external_depth.hpp"
#include "ramify/statistic/fill_level.hpp"
#include "ramify/statistic/height.hpp"
#include "ramify/statistic/horton_law.hpp"
#include "ramify/statistic/last_node_depth.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/statistic/row_parts.hpp"
#include "ramify/statistic/shape_indices.hpp"
#include "ramify/statistic/tree_indices.hpp"

namespace ramify {
namespace {

using namespace detail;

constexpr std::string_view leaf_order_0 = "leaf order 0";

/// One estimator of the bifurcation ratio, of the orders 0..S that the tree has.
template <HortonStrahler::Counts TreeMeasures::* counts, double OrderRatios::* estimator>
StatisticValue ratio(const TreeMeasures& m, OrderPlace) {
  return real(order_ratios(std::span(m.*counts).first(m.strahler + 1u)).*estimator);
}

template <auto member, std::uint64_t more = 0>
StatisticValue number(const TreeMeasures& m, OrderPlace) {
  return whole(m.*member + more);
}

template <HortonStrahler::Counts TreeMeasures::* counts>
StatisticValue count(const TreeMeasures& m, OrderPlace order) {
  return whole((m.*counts)[order.high]);
}

/// Horton's first law at the tree's own mean ratio of nodes: how many nodes it gives a tree of its order, and
/// what order a tree of its size.
double own_ratio(const TreeMeasures& m) {
  return order_ratios(std::span(m.nodes).first(m.strahler + 1u)).mean_ratio;
}
StatisticValue size_by_horton(const TreeMeasures& m, OrderPlace) {
  return real(horton_size(own_ratio(m), m.strahler));
}
StatisticValue order_by_horton(const TreeMeasures& m, OrderPlace) {
  return real(horton_order(own_ratio(m), static_cast<double>(m.size)));
}

StatisticValue colless_index(const TreeMeasures& m, OrderPlace) {
  StatisticValue value = whole(m.colless);
  if (m.is_wide) value.whole = no_whole;
  return value;
}

StatisticValue cherries(const TreeMeasures& m, OrderPlace) {
  return whole(m.streams[1]);
}

template <HortonStrahler::Counts TreeMeasures::* counts>
StatisticValue order_ratio(const TreeMeasures& m, OrderPlace order) {
  return quotient((m.*counts)[order.high - 1], (m.*counts)[order.high]);
}

StatisticValue stream_length(const TreeMeasures& m, OrderPlace order) {
  return quotient(m.nodes[order.high], m.streams[order.high]);
}

StatisticValue tokunaga(const TreeMeasures& m, OrderPlace place) {
  return quotient(m.bi_orders.side_branches(place.low, place.high), m.streams[place.high]);
}

StatisticValue pooled_tokunaga(const TreeMeasures& m, OrderPlace place) {
  const std::size_t k = place.high;
  std::uint64_t branches = 0, streams = 0;
  for (std::size_t high = k; high <= m.strahler; ++high) {
    branches += m.bi_orders.side_branches(high - k, high);
    streams += m.streams[high];
  }
  return quotient(branches, streams);
}

StatisticValue ramification(const TreeMeasures& m, OrderPlace place) {
  const bool begins = place.low == place.high;
  return quotient(
      begins ? m.bi_orders.joined(place.high - 1, place.high - 1) : m.bi_orders.joined(place.high, place.low),
      m.bi_orders.nodes(place.high));
}

constexpr StatisticInfo whole_number(std::string_view name, std::string_view convention,
                                     std::string_view description, std::string_view source, FoldSet folds,
                                     Read value, ExactLaw law = {}) {
  return {name, convention, description, source, false, Columns::one, folds, value, law};
}

constexpr StatisticInfo order_counts(std::string_view name, std::string_view description,
                                     std::string_view source, Read value, OrderCount::Of of) {
  return {name,           leaf_order_0, description,       source, false, Columns::orders,
          Folded::counts, value,        {CountOfOrder{of}}};
}

constexpr StatisticInfo tree_ratio(std::string_view name, std::string_view convention,
                                   std::string_view description, Read value) {
  return {name, convention, description, "B11", true, Columns::one, Folded::counts, value};
}

constexpr StatisticInfo by_orders(std::string_view name, std::string_view description,
                                  std::string_view source, Columns shape, FoldSet folds, Read value) {
  return {name, leaf_order_0, description, source, true, shape, folds, value};
}

constexpr StatisticInfo from_streams(StatisticInfo row) {
  row.from_streams = true;
  return row;
}

constexpr StatisticInfo as_order(StatisticInfo row) {
  row.is_order = true;
  return row;
}

constexpr AffineMap one_more(double) {
  return {1, 1};
}

using M = TreeMeasures;
using R = OrderRatios;

constexpr StatisticInfo rows[] = {
    whole_number("size", "internal nodes", "n, counted on the tree", "B1", {}, number<&M::size>,
                 {KnownBySize{0}}),
    from_streams(whole_number("magnitude", "external nodes", "Shreve magnitude: n+1 in a binary tree", "B2",
                              Folded::counts, count<&M::streams>, {KnownBySize{1}})),
    as_order(
        from_streams(whole_number("strahler", leaf_order_0, "Horton-Strahler number: order of the root", "B6",
                                  Folded::strahler, number<&M::strahler>, {Strahler::recurrence}))),
    from_streams(whole_number("registers", "registers, one at least",
                              "fewest that evaluate the tree as an expression: Horton-Strahler number + 1",
                              "B21", Folded::strahler, number<&M::strahler, 1>,
                              {Strahler::recurrence, one_more})),
    whole_number("height", "nodes on the path, root and external node counted", "longest root-to-leaf path",
                 "B4", Folded::height, number<&M::height>, {Height::recurrence}),
    whole_number("depth", "nodes on the path, root counted; 0 for n = 0",
                 "D_n of the last node: from size n >= 2 to a child of size i with probability i/(n-1)",
                 "B23", Folded::depth, number<&M::depth>, {LastNodeDepth::recurrence}),
    whole_number("external_depth", "nodes on the path, both ends counted",
                 "depth of an external node drawn uniformly from all", "B23", Folded::external_depth,
                 number<&M::external_depth>, {ExternalDepth::recurrence}),
    whole_number("path_length", "edges from the root, internal nodes",
                 "sum of the depths of all internal nodes", "B23", Folded::path_sums, number<&M::path_length>,
                 {NodeSum{ShapeIndices::path_length_toll}}),
    whole_number("sackin", "edges from the root, external nodes",
                 "sum of the depths of all external nodes (Sackin 1972)", "B23", Folded::path_sums,
                 number<&M::sackin>, {NodeSum{ShapeIndices::sackin_toll}}),
    binary(whole_number("colless", "external nodes, nodes with two children",
                        "sum of the differences of left and right (Colless 1982)", "B23", Folded::path_sums,
                        colless_index, {NodeSum{ShapeIndices::colless_toll}})),
    whole_number("cherries", "two or more external nodes below one, one-child nodes contracted",
                 "streams of order 1, leaf order 0", "B8", Folded::counts, cherries,
                 {CountOfOrder{OrderCount::Of::streams, 1}}),
    whole_number("width", "external nodes counted", "nodes of the fullest level", "B23", Folded::profile,
                 number<&M::width>),
    whole_number("fill_level", "root at level 0, external nodes counted", "deepest level with all its nodes",
                 "B18", Folded::fill_level, number<&M::fill_level>, {FillLevel::recurrence}),
    whole_number("balance", "0 for an external node", "most edges to a smaller-or-equal child on a path",
                 "B16", Folded::balance, number<&M::balance>, {Balance::recurrence}),
    whole_number("alternate_balance", "1 for an external node",
                 "balance + 1, as the thesis's B* comes out (X33)", "B17", Folded::balance,
                 number<&M::balance, 1>, {Balance::recurrence, one_more}),
    order_counts("nodes", "nodes of order k", "B9", count<&M::nodes>, OrderCount::Of::nodes),
    from_streams(order_counts("streams", "streams of order k: maximal chains", "B8", count<&M::streams>,
                              OrderCount::Of::streams)),
    tree_ratio("nodes_mean_ratio", "nodes, within one tree", "mean of N_k/N_(k+1): the thesis's R",
               ratio<&M::nodes, &R::mean_ratio>),
    tree_ratio("nodes_regression", "nodes, within one tree, orders 0..S",
               "exp of minus the slope of log N_k on k", ratio<&M::nodes, &R::regression>),
    tree_ratio("nodes_geometric", "nodes, within one tree", "(N_0/N_S)^(1/S)",
               ratio<&M::nodes, &R::geometric>),
    from_streams(tree_ratio("streams_mean_ratio", "streams, within one tree", "mean of M_k/M_(k+1)",
                            ratio<&M::streams, &R::mean_ratio>)),
    from_streams(tree_ratio("streams_regression", "streams, within one tree, orders 0..S",
                            "exp of minus the slope of log M_k on k: what biologists print",
                            ratio<&M::streams, &R::regression>)),
    from_streams(tree_ratio("streams_geometric", "streams, within one tree", "(M_0/M_S)^(1/S)",
                            ratio<&M::streams, &R::geometric>)),
    {"horton_size", "internal nodes, nodes_mean_ratio R", "(R^S - 1)/(R - 1): n by Horton's first law", "B12",
     true, Columns::one, Folded::counts, size_by_horton},
    as_order({"horton_order", "leaf order 0, nodes_mean_ratio R",
              "log(n(R - 1) + 1)/log R: the Horton-Strahler number by Horton's first law", "B12", true,
              Columns::one, Folded::counts, order_by_horton}),
    by_orders("nodes_ratio", "N_(k-1)/N_k", "B10", Columns::upper_orders, Folded::counts,
              order_ratio<&M::nodes>),
    from_streams(by_orders("streams_ratio", "M_(k-1)/M_k", "B10", Columns::upper_orders, Folded::counts,
                           order_ratio<&M::streams>)),
    by_orders("stream_length", "nodes in a stream of order k, on average: N_k/M_k", "B24",
              Columns::upper_orders, Folded::counts, stream_length),
    by_orders("ramification",
              "share of the nodes of order i whose children have the orders i and j; j = i: i-1 and i-1",
              "B14", Columns::pairs, Folded::bi_orders, ramification),
    by_orders("side_branches",
              "T_ij: streams of order j that join a stream of order i > j from the side, on average",
              "Tokunaga 1978", Columns::lower_pairs, {Folded::bi_orders, Folded::counts}, tokunaga),
    by_orders("tokunaga", "T_k: the same for streams k orders below, over all streams of order k and more",
              "Tokunaga 1978", Columns::differences, {Folded::bi_orders, Folded::counts}, pooled_tokunaga),
};

/// The row of that name; does not compile where there is none.
consteval const StatisticInfo& row(std::string_view name) {
  for (const StatisticInfo& info : rows)
    if (info.name == name) return info;
  throw "no such statistic";
}

}  // namespace

namespace statistic {
const StatisticInfo &strahler = row("strahler"), &height = row("height"), &depth = row("depth"),
                    &width = row("width"), &fill_level = row("fill_level"), &balance = row("balance"),
                    &cherries = row("cherries"), &sackin = row("sackin"), &colless = row("colless"),
                    &nodes = row("nodes"), &streams = row("streams"),
                    &nodes_mean_ratio = row("nodes_mean_ratio"),
                    &streams_mean_ratio = row("streams_mean_ratio");
}  // namespace statistic

const std::vector<std::reference_wrapper<const StatisticInfo>>& statistics() {
  static const auto all = [] {
    std::vector<std::reference_wrapper<const StatisticInfo>> list(std::begin(rows), std::end(rows));
    for (const StatisticInfo& index : tree_indices()) list.emplace_back(index);
    return list;
  }();
  return all;
}

}  // namespace ramify
