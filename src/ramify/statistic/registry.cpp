#include "ramify/statistic/registry.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/order_ratios.hpp"

namespace ramify {
namespace {

constexpr std::string_view leaf_order_0 = "leaf order 0";

std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const auto& info : statistics()) names.emplace_back(info.name);
  return names;
}

StatisticValue whole(std::uint64_t value) {
  StatisticValue result;
  result.whole = static_cast<std::int64_t>(value);
  return result;
}

/// One estimator of the bifurcation ratio, of the orders 0..S that the tree has.
template <HortonStrahler::Counts TreeMeasures::* counts, double OrderRatios::* estimator>
StatisticValue ratio(const TreeMeasures& m, std::size_t) {
  StatisticValue result;
  result.real = order_ratios(std::span(m.*counts).first(m.strahler + 1u)).*estimator;
  return result;
}

template <auto member>
StatisticValue number(const TreeMeasures& m, std::size_t) {
  return whole(m.*member);
}

template <HortonStrahler::Counts TreeMeasures::* counts>
StatisticValue count(const TreeMeasures& m, std::size_t order) {
  return whole((m.*counts)[order]);
}

StatisticInfo whole_number(std::string_view name, std::string_view convention, std::string_view description,
                           std::string_view source, Measure measure,
                           StatisticValue (*value)(const TreeMeasures&, std::size_t)) {
  return {name, convention, description, source, false, false, measure, value};
}

StatisticInfo order_counts(std::string_view name, std::string_view description, std::string_view source,
                           StatisticValue (*value)(const TreeMeasures&, std::size_t)) {
  return {name, leaf_order_0, description, source, false, true, Measure::counts, value};
}

StatisticInfo order_ratio(std::string_view name, std::string_view convention, std::string_view description,
                          StatisticValue (*value)(const TreeMeasures&, std::size_t)) {
  return {name, convention, description, "B11", true, false, Measure::counts, value};
}

}  // namespace

const std::vector<StatisticInfo>& statistics() {
  using M = TreeMeasures;
  using R = OrderRatios;
  static const std::vector<StatisticInfo> all{
      whole_number("size", "internal nodes", "n, counted on the tree", "B1", Measure::size, number<&M::size>),
      whole_number("strahler", leaf_order_0, "Horton-Strahler number: order of the root", "B6",
                   Measure::strahler, number<&M::strahler>),
      whole_number("height", "nodes on the path, root and external node counted", "longest root-to-leaf path",
                   "B4", Measure::height, number<&M::height>),
      whole_number("depth", "nodes on the path, root counted; 0 for n = 0",
                   "D_n of the last node: from size n >= 2 to a child of size i with probability i/(n-1)",
                   "B23", Measure::depth, number<&M::depth>),
      whole_number("fill_level", "root at level 0, external nodes counted",
                   "deepest level with all its nodes", "B18", Measure::fill_level, number<&M::fill_level>),
      whole_number("balance", "0 for an external node", "most edges to a smaller-or-equal child on a path",
                   "B16", Measure::balance, number<&M::balance>),
      order_counts("nodes", "nodes of order k", "B9", count<&M::nodes>),
      order_counts("streams", "streams of order k: maximal chains", "B8", count<&M::streams>),
      order_ratio("nodes_mean_ratio", "nodes, within one tree", "mean of N_k/N_(k+1): the thesis's R",
                  ratio<&M::nodes, &R::mean_ratio>),
      order_ratio("nodes_regression", "nodes, within one tree, orders 0..S",
                  "exp of minus the slope of log N_k on k", ratio<&M::nodes, &R::regression>),
      order_ratio("nodes_geometric", "nodes, within one tree", "(N_0/N_S)^(1/S)",
                  ratio<&M::nodes, &R::geometric>),
      order_ratio("streams_mean_ratio", "streams, within one tree", "mean of M_k/M_(k+1)",
                  ratio<&M::streams, &R::mean_ratio>),
      order_ratio("streams_regression", "streams, within one tree, orders 0..S",
                  "exp of minus the slope of log M_k on k: what biologists print",
                  ratio<&M::streams, &R::regression>),
      order_ratio("streams_geometric", "streams, within one tree", "(M_0/M_S)^(1/S)",
                  ratio<&M::streams, &R::geometric>),
  };
  return all;
}

std::string StatisticInfo::columns() const {
  return per_order ? fmt::format("{0}_0..{0}_K", name) : std::string(name);
}

StatisticSet StatisticSet::parse(std::span<const std::string> names) {
  StatisticSet set;
  const auto& all = statistics();
  for (const auto& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& info) { return info.name == name; });
    if (found == all.end())
      throw Error(fmt::format("unknown statistic '{}'", name), "no statistic has that name",
                  did_you_mean(name, known_names()) + "see: ramify list statistics");
    if (set.contains(name))
      throw Error(fmt::format("statistic '{}' given twice", name), "each becomes one set of columns",
                  "name it once");
    set.chosen_.push_back(&*found);
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

std::vector<std::string> StatisticSet::columns(Size n) const {
  std::vector<std::string> names;
  for (const auto* info : chosen_) {
    if (!info->per_order) {
      names.emplace_back(info->name);
      continue;
    }
    for (std::size_t k = 0; k <= HortonStrahler::largest_order(n); ++k)
      names.push_back(fmt::format("{}_{}", info->name, k));
  }
  return names;
}

void write_statistics(const StatisticSet& statistics, const TreeMeasures& measures,
                      std::vector<StatisticValue>& row) {
  row.clear();
  for (const auto* info : statistics.chosen()) {
    const std::size_t last = info->per_order ? HortonStrahler::largest_order(measures.size) : 0;
    for (std::size_t k = 0; k <= last; ++k) row.push_back(info->value(measures, k));
  }
}

}  // namespace ramify
