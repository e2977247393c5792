#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ramify/format/order_counts.hpp"
#include "ramify/statistic/murray_exponent.hpp"
#include "ramify/statistic/tree_measures.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// What `ramify measure` says of the orders of a tree, leaf order 0.
struct MeasuredOrders {
  std::string name;
  std::vector<std::uint64_t> nodes;  ///< of orders 0..S; empty where only streams are known
  std::vector<std::uint64_t> streams;
  std::vector<double> mean_lengths;  ///< of the streams of orders 0..S, NaN where none; or empty
  std::vector<double> mean_radii;    ///< likewise
  std::vector<double> mean_areas;    ///< of drainage, likewise; of published tables alone
  MurrayExponent murray{};           ///< fork by fork; of none where there is no tree with radii
};

/// All that it says of a tree.
struct TreeMeasurement {
  MeasuredOrders orders;
  std::optional<TreeMeasures> measures;  ///< nothing where only counts of streams are known
};

/// Orders, with the rule B22 where a node has more than two children: m + 1 if two or more of them have the
/// highest order m, else m. One-child nodes inherit: contract them first where they are not to be counted.
/// O(nodes).
MeasuredOrders measure_orders(const RecordedTree& tree);

/// Everything. The walks to the last and to an external node take their choices from a stream of their own,
/// the same for every tree. O(nodes).
TreeMeasurement measure_all(const RecordedTree& tree);

/// The same of a published table; radii are half of its diameters.
MeasuredOrders measure_orders(const OrderCounts& counts);

/// C_0 + ... + C_(S-1) over C_1 + ... + C_S: the ratio of one tree pooled over its orders; NaN where S = 0.
double pooled_over_orders(const std::vector<std::uint64_t>& counts);

}  // namespace ramify
