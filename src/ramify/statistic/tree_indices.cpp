#include "ramify/statistic/tree_indices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ramify/statistic/row_parts.hpp"
#include "ramify/statistic/shape_indices.hpp"
#include "ramify/statistic/toll_sums.hpp"

namespace ramify {
namespace {

using namespace detail;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double leaves_of(const TreeMeasures& m) {
  return static_cast<double>(m.streams[0]);
}

// ---- tolls, of the numbers of external nodes of a node's children ----

double pairs(double leaves) {
  return leaves * (leaves - 1) / 2;
}

/// A toll of nodes with two children: 0 of one-child nodes, undefined of others.
template <double (*toll)(double left, double right)>
double of_two(std::span<const double> leaves) {
  if (leaves.size() == 1) return 0;
  return leaves.size() == 2 ? toll(leaves[0], leaves[1]) : undefined;
}

/// Below the children, so that the root is left out.
double cophenetic_toll(std::span<const double> leaves) {
  double sum = 0;
  for (const double below : leaves) sum += pairs(below);
  return sum;
}

double quartets_of(double left, double right) {
  return 3 * pairs(left) * pairs(right);
}

double differ(double left, double right) {
  return left == right ? 0 : 1;
}

double smaller_over_larger(double left, double right) {
  return std::min(left, right) / std::max(left, right);
}

double pitchfork_toll(std::span<const double> leaves) {
  return leaves.size() > 1 && std::accumulate(leaves.begin(), leaves.end(), 0.0) == 3 ? 1 : 0;
}

/// Leaves times the entropy of how they divide, to the base of the number of children.
double entropy_toll(std::span<const double> leaves) {
  if (leaves.size() == 1) return 0;
  const double all = std::accumulate(leaves.begin(), leaves.end(), 0.0);
  double sum = 0;
  for (const double below : leaves) sum -= below * std::log(below / all);
  return sum / std::log(static_cast<double>(leaves.size()));
}

// ---- what is read off a measured tree ----

double sum_of(const TreeMeasures& m, Toll toll) {
  const auto& tolls = all_tolls();
  return m.toll_sums[static_cast<std::size_t>(std::ranges::find(tolls, toll) - tolls.begin())];
}

template <Toll toll>
StatisticValue toll_total(const TreeMeasures& m, OrderPlace) {
  return real(sum_of(m, toll));
}

template <Toll toll>
StatisticValue toll_count(const TreeMeasures& m, OrderPlace) {
  return whole(static_cast<std::uint64_t>(sum_of(m, toll)));
}

/// Over the nodes with two children.
template <Toll toll>
StatisticValue mean_over_forks(const TreeMeasures& m, OrderPlace) {
  return quotient(sum_of(m, toll), leaves_of(m) - 1);
}

template <Toll toll>
StatisticValue mean_over_leaf_depths(const TreeMeasures& m, OrderPlace) {
  return quotient(sum_of(m, toll), static_cast<double>(m.sackin));
}

template <class Fold>
StatisticValue index_value(const TreeMeasures& m, OrderPlace) {
  return real(m.indices[IndexFolds::place_of<Fold>]);
}

StatisticValue average_leaf_depth(const TreeMeasures& m, OrderPlace) {
  return real(static_cast<double>(m.sackin) / leaves_of(m));
}

StatisticValue width_over_depth(const TreeMeasures& m, OrderPlace) {
  return quotient(static_cast<double>(m.width), static_cast<double>(m.height - 1));
}

// ---- rows ----

constexpr AffineMap over_leaves(double n) {
  return {1 / (n + 1), 0};
}
constexpr AffineMap over_nodes(double n) {
  return {1 / n, 0};
}

/// A real number, one column.
constexpr StatisticInfo one_index(std::string_view name, std::string_view convention,
                                  std::string_view description, std::string_view source, FoldSet folds,
                                  Read value, ExactLaw law = {}) {
  return {name, convention, description, source, true, Columns::one, folds, value, law};
}

/// Read off the sum of a toll.
constexpr StatisticInfo with_toll(Toll toll, StatisticInfo row) {
  row.toll = toll;
  return row;
}

constexpr FoldSet counts_and_indices{Folded::counts, Folded::indices};

constexpr StatisticInfo index_rows[] = {
    with_toll(cophenetic_toll,
              one_index("total_cophenetic", "edges from the root, pairs of external nodes; exact below 2^53",
                        "sum over the pairs of the depth of their last common node",
                        "Mir, Rossello and Rotger 2013", Folded::indices, toll_total<cophenetic_toll>,
                        {NodeSum{cophenetic_toll}})),
    binary(with_toll(
        of_two<quartets_of>,
        one_index("rooted_quartets", "quartets of external nodes, a balanced one counts 3; exact below 2^53",
                  "3 times the quartets that part two and two", "Coronado et al. 2019", Folded::indices,
                  toll_total<of_two<quartets_of>>, {NodeSum{of_two<quartets_of>}}))),
    one_index("b1", "edges to the deepest external node below, internal nodes without the root",
              "sum of 1 over the heights of the nodes", "Shao and Sokal 1990", Folded::indices,
              index_value<B1>),
    one_index("b2", "bits", "entropy of the external node that a walk reaches, all children being alike",
              "Shao and Sokal 1990", Folded::indices, index_value<B2>, {B2::recurrence}),
    one_index("average_leaf_depth", "edges from the root, external nodes", "sackin over external nodes",
              "Kirkpatrick and Slatkin 1993", {Folded::path_sums, Folded::counts}, average_leaf_depth,
              {NodeSum{ShapeIndices::sackin_toll}, over_leaves}),
    one_index("variance_leaf_depth", "edges from the root, external nodes; divisor their number",
              "variance of the depths of all external nodes", "Kirkpatrick and Slatkin 1993", Folded::indices,
              index_value<LeafDepthVariance>),
    one_index("maximum_width_over_maximum_depth", "external nodes counted, depth in edges",
              "nodes of the fullest level over the largest depth", "Colijn and Gardy 2014",
              {Folded::profile, Folded::height}, width_over_depth),
    binary(with_toll(of_two<differ>,
                     one_index("stairs1", "external nodes, over the nodes with two children",
                               "share of the nodes whose sides have different numbers of external nodes",
                               "Norstrom et al. 2012", counts_and_indices, mean_over_forks<of_two<differ>>,
                               {NodeSum{of_two<differ>}, over_nodes}))),
    binary(with_toll(of_two<smaller_over_larger>,
                     one_index("stairs2", "external nodes, over the nodes with two children",
                               "mean of the smaller over the larger side", "Norstrom et al. 2012",
                               counts_and_indices, mean_over_forks<of_two<smaller_over_larger>>,
                               {NodeSum{of_two<smaller_over_larger>}, over_nodes}))),
    binary(one_index("symmetry_nodes", "nodes with two children that are not symmetric",
                     "nodes whose two subtrees differ in shape", "Kersting and Fischer 2021", Folded::indices,
                     index_value<SymmetryNodes>)),
    with_toll(pitchfork_toll, {"pitchforks",
                               "nodes with two children or more",
                               "nodes with three external nodes below",
                               "Rosenberg 2006",
                               false,
                               Columns::one,
                               Folded::indices,
                               toll_count<pitchfork_toll>,
                               {NodeSum{pitchfork_toll}}}),
    with_toll(
        entropy_toll,
        one_index("j1", "external nodes of equal size; entropy to the base of a node's children",
                  "mean balance of the nodes, weighted by the external nodes below", "Lemant et al. 2022",
                  {Folded::indices, Folded::path_sums}, mean_over_leaf_depths<entropy_toll>)),
};

}  // namespace

std::span<const StatisticInfo> tree_indices() {
  return index_rows;
}

}  // namespace ramify
