#pragma once

#include "ramify/statistic/statistic_set.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

// What is folded together while a tree grows; what is folded alone is a set of one.

/// What nearly every run asks.
inline constexpr FoldSet orders_and_height{Folded::strahler, Folded::counts, Folded::height};

/// Those, and the lengths of other paths: to the last node, to the highest leaf, of small children.
inline constexpr FoldSet orders_and_paths =
    orders_and_height | FoldSet{Folded::depth, Folded::fill_level, Folded::balance};

/// Those, and what is not grafted: every node is grown.
inline constexpr FoldSet all_but_indices =
    orders_and_paths | FoldSet{Folded::external_depth, Folded::path_sums, Folded::profile, Folded::bi_orders};

/// All there is.
inline constexpr FoldSet all_folds = all_but_indices | Folded::indices;

/// Order, and counts of which the small subtrees are averaged (mean_counts.hpp).
inline constexpr FoldSet orders_and_mean_counts{Folded::strahler, Folded::mean_counts};

/// How the trees of a run are sampled: a fixed function of the statistics that are asked for.
struct SamplingMethod {
  FoldSet pass;
  bool graft;  ///< false: every node is grown, and more than one thing folded

  friend bool operator==(const SamplingMethod&, const SamplingMethod&) = default;
};

/// Every node is grown.
constexpr SamplingMethod whole_trees(FoldSet pass) {
  return {pass, false};
}

/// One fold alone (and the size) has a pass of its own where it can be grafted or walked; others share the
/// least of the sets above that holds them.
SamplingMethod sampling_method(const StatisticSet& statistics, bool graft);

/// The largest n whose trees are sampled with the counts of all their nodes, where ratios of counts are asked
/// for again and again; above it the counts of small subtrees are averaged (mean_counts.hpp). That changes
/// the expected ratio by less than a thousandth, and the spread of a tree's ratio by less than a hundredth of
/// it (docs/fitting.md).
inline constexpr Size largest_counted = Size{1} << 20;

/// How trees are sampled for that.
constexpr SamplingMethod sampling_of_counts(Size n) {
  return {n <= largest_counted ? orders_and_height : orders_and_mean_counts, true};
}

/// Every node is grown, whatever the method says.
constexpr bool is_streamed(FoldSet pass) {
  return pass.contains(all_but_indices);
}

/// A walk down, with nothing grown beside it.
constexpr bool is_walk(FoldSet pass) {
  return pass == Folded::depth || pass == Folded::external_depth;
}

/// What a pass folds: "strahler", "order, height and counts".
std::string_view describe(FoldSet pass);

}  // namespace ramify
