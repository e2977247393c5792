#include "ramify/statistic/registry.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/find_named.hpp"
#include "ramify/statistic/horton_law.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/order_ratios.hpp"

namespace ramify {
namespace {

constexpr std::string_view leaf_order_0 = "leaf order 0";

StatisticValue whole(std::uint64_t value) {
  StatisticValue result;
  result.whole = static_cast<std::int64_t>(value);
  return result;
}

StatisticValue real(double value) {
  StatisticValue result;
  result.real = value;
  return result;
}

/// NaN where nothing is divided.
StatisticValue quotient(std::uint64_t above, std::uint64_t below) {
  return real(below == 0 ? std::numeric_limits<double>::quiet_NaN()
                         : static_cast<double>(above) / static_cast<double>(below));
}

using Read = StatisticValue (*)(const TreeMeasures&, OrderPlace);

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

StatisticInfo whole_number(std::string_view name, std::string_view convention, std::string_view description,
                           std::string_view source, Measure measure, Read value) {
  return {name, convention, description, source, false, Columns::one, measure, value};
}

StatisticInfo order_counts(std::string_view name, std::string_view description, std::string_view source,
                           Read value) {
  return {name, leaf_order_0, description, source, false, Columns::orders, Measure::counts, value};
}

StatisticInfo tree_ratio(std::string_view name, std::string_view convention, std::string_view description,
                         Read value) {
  return {name, convention, description, "B11", true, Columns::one, Measure::counts, value};
}

StatisticInfo by_orders(std::string_view name, std::string_view description, std::string_view source,
                        Columns shape, Measure measure, Read value) {
  return {name, leaf_order_0, description, source, true, shape, measure, value};
}

}  // namespace

const std::vector<StatisticInfo>& statistics() {  // NOLINT(readability-function-size): a table
  using M = TreeMeasures;
  using R = OrderRatios;
  static const std::vector<StatisticInfo> all{
      whole_number("size", "internal nodes", "n, counted on the tree", "B1", Measure::size, number<&M::size>),
      whole_number("magnitude", "external nodes", "Shreve magnitude: n+1 in a binary tree", "B2",
                   Measure::counts, count<&M::streams>),
      {"strahler", leaf_order_0, "Horton-Strahler number: order of the root", "B6", false, Columns::one,
       Measure::strahler, number<&M::strahler>, false, true},
      whole_number("registers", "registers, one at least",
                   "fewest that evaluate the tree as an expression: Horton-Strahler number + 1", "B21",
                   Measure::strahler, number<&M::strahler, 1>),
      whole_number("height", "nodes on the path, root and external node counted", "longest root-to-leaf path",
                   "B4", Measure::height, number<&M::height>),
      whole_number("depth", "nodes on the path, root counted; 0 for n = 0",
                   "D_n of the last node: from size n >= 2 to a child of size i with probability i/(n-1)",
                   "B23", Measure::depth, number<&M::depth>),
      whole_number("external_depth", "nodes on the path, both ends counted",
                   "depth of an external node drawn uniformly from all", "B23", Measure::external_depth,
                   number<&M::external_depth>),
      whole_number("path_length", "edges from the root, internal nodes",
                   "sum of the depths of all internal nodes", "B23", Measure::shape, number<&M::path_length>),
      whole_number("sackin", "edges from the root, external nodes",
                   "sum of the depths of all external nodes (Sackin 1972)", "B23", Measure::shape,
                   number<&M::sackin>),
      {"colless", "external nodes, nodes with two children",
       "sum of the differences of left and right (Colless 1982)", "B23", false, Columns::one, Measure::shape,
       number<&M::colless>, true},
      whole_number("cherries", "two or more external nodes below one, one-child nodes contracted",
                   "streams of order 1, leaf order 0", "B8", Measure::counts, cherries),
      whole_number("width", "external nodes counted", "nodes of the fullest level", "B23", Measure::profile,
                   number<&M::width>),
      whole_number("fill_level", "root at level 0, external nodes counted",
                   "deepest level with all its nodes", "B18", Measure::fill_level, number<&M::fill_level>),
      whole_number("balance", "0 for an external node", "most edges to a smaller-or-equal child on a path",
                   "B16", Measure::balance, number<&M::balance>),
      whole_number("alternate_balance", "1 for an external node",
                   "balance + 1, as the thesis's B* comes out (X33)", "B17", Measure::balance,
                   number<&M::balance, 1>),
      order_counts("nodes", "nodes of order k", "B9", count<&M::nodes>),
      order_counts("streams", "streams of order k: maximal chains", "B8", count<&M::streams>),
      tree_ratio("nodes_mean_ratio", "nodes, within one tree", "mean of N_k/N_(k+1): the thesis's R",
                 ratio<&M::nodes, &R::mean_ratio>),
      tree_ratio("nodes_regression", "nodes, within one tree, orders 0..S",
                 "exp of minus the slope of log N_k on k", ratio<&M::nodes, &R::regression>),
      tree_ratio("nodes_geometric", "nodes, within one tree", "(N_0/N_S)^(1/S)",
                 ratio<&M::nodes, &R::geometric>),
      tree_ratio("streams_mean_ratio", "streams, within one tree", "mean of M_k/M_(k+1)",
                 ratio<&M::streams, &R::mean_ratio>),
      tree_ratio("streams_regression", "streams, within one tree, orders 0..S",
                 "exp of minus the slope of log M_k on k: what biologists print",
                 ratio<&M::streams, &R::regression>),
      tree_ratio("streams_geometric", "streams, within one tree", "(M_0/M_S)^(1/S)",
                 ratio<&M::streams, &R::geometric>),
      {"horton_size", "internal nodes, nodes_mean_ratio R", "(R^S - 1)/(R - 1): n by Horton's first law",
       "B12", true, Columns::one, Measure::counts, size_by_horton},
      {"horton_order", "leaf order 0, nodes_mean_ratio R",
       "log(n(R - 1) + 1)/log R: the Horton-Strahler number by Horton's first law", "B12", true, Columns::one,
       Measure::counts, order_by_horton, false, true},
      by_orders("nodes_ratio", "N_(k-1)/N_k", "B10", Columns::upper_orders, Measure::counts,
                order_ratio<&M::nodes>),
      by_orders("streams_ratio", "M_(k-1)/M_k", "B10", Columns::upper_orders, Measure::counts,
                order_ratio<&M::streams>),
      by_orders("stream_length", "nodes in a stream of order k, on average: N_k/M_k", "B24",
                Columns::upper_orders, Measure::counts, stream_length),
      by_orders("ramification",
                "share of the nodes of order i whose children have the orders i and j; j = i: i-1 and i-1",
                "B14", Columns::pairs, Measure::bi_orders, ramification),
      by_orders("side_branches",
                "T_ij: streams of order j that join a stream of order i > j from the side, on average",
                "Tokunaga 1978", Columns::lower_pairs, Measure::bi_orders, tokunaga),
      by_orders("tokunaga", "T_k: the same for streams k orders below, over all streams of order k and more",
                "Tokunaga 1978", Columns::differences, Measure::bi_orders, pooled_tokunaga),
  };
  return all;
}

std::string StatisticInfo::columns() const {
  switch (shape) {
    case Columns::one:
      return std::string(name);
    case Columns::orders:
      return fmt::format("{0}_0..{0}_K", name);
    case Columns::upper_orders:
    case Columns::differences:
      return fmt::format("{0}_1..{0}_K", name);
    case Columns::pairs:
      return fmt::format("{0}_1_0..{0}_K_K", name);
    case Columns::lower_pairs:
      return fmt::format("{0}_1_0..{0}_K_(K-1)", name);
  }
  return {};
}

std::string StatisticInfo::column_name(OrderPlace place, std::size_t leaf_order) const {
  if (shape == Columns::one) return std::string(name);
  if (shape == Columns::differences) return fmt::format("{}_{}", name, place.high);
  if (!by_pairs()) return fmt::format("{}_{}", name, place.high + leaf_order);
  return fmt::format("{}_{}_{}", name, place.high + leaf_order, place.low + leaf_order);
}

std::vector<OrderPlace> StatisticInfo::places(std::size_t largest_order) const {
  if (shape == Columns::one) return {{0, 0}};
  std::vector<OrderPlace> places;
  for (std::size_t high = shape == Columns::orders ? 0 : 1; high <= largest_order; ++high) {
    const std::size_t last = !by_pairs() ? 0 : shape == Columns::pairs ? high : high - 1;
    for (std::size_t low = 0; low <= last; ++low) places.push_back({high, low});
  }
  return places;
}

StatisticSet StatisticSet::parse(std::span<const std::string> names) {
  StatisticSet set;
  for (const auto& name : names) {
    const StatisticInfo& info = find_named(statistics(), &StatisticInfo::name, name, "statistic");
    if (set.contains(name))
      throw Error(fmt::format("statistic '{}' given twice", name), "each becomes one set of columns",
                  "name it once");
    set.chosen_.push_back(&info);
  }
  if (set.chosen_.empty())
    throw Error("no statistic", "there is nothing to measure",
                "name one or more; see: ramify list statistics");
  return set;
}

bool StatisticSet::contains(std::string_view name) const {
  return std::any_of(chosen_.begin(), chosen_.end(), [&](const auto* info) { return info->name == name; });
}

bool StatisticSet::reads(Measure measure) const {
  return std::any_of(chosen_.begin(), chosen_.end(),
                     [measure](const auto* info) { return info->measure == measure; });
}

bool StatisticSet::reads_only(Measure measure) const {
  return std::all_of(chosen_.begin(), chosen_.end(), [measure](const auto* info) {
    return info->measure == measure || info->measure == Measure::size;
  });
}

std::vector<StatisticSet::Column> StatisticSet::columns(std::size_t largest_order) const {
  std::vector<Column> columns;
  for (const auto* info : chosen_) {
    for (const OrderPlace place : info->places(largest_order))
      columns.push_back({info->column_name(place), info, place});
  }
  return columns;
}

void write_statistics(const std::vector<StatisticSet::Column>& columns, const TreeMeasures& measures,
                      std::vector<StatisticValue>& row) {
  row.clear();
  for (const auto& column : columns) row.push_back(column.statistic->value(measures, column.place));
}

}  // namespace ramify
