#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/family/observed_bi_orders.hpp"
#include "ramify/fit/count_likelihood.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Families that are fitted to data, and how.
struct ModelFitOptions {
  std::vector<const Family*> families;
  std::uint64_t bootstrap_trees = 0;  ///< of every fit; none: no bootstrap
  std::uint64_t seed = 1996;
  Workforce workforce = 1;                        ///< decides the time alone
  CountDensity density = CountDensity::gaussian;  ///< of counts
  bool valleys = false;  ///< of counts: pairs of shapes that fit nearly as well (valley.hpp)
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::function<void(double done, double total)> progress = {};  ///< in fits; may be empty
};

/// One tree or table of counts with all families that were fitted to it.
struct FittedDatum {
  std::string data;
  std::string_view observable;  ///< "orders", "tree", and "tree given order"
  Size n;                       ///< internal nodes
  std::string used;             ///< of the observation: "orders 1..5 and S"
  std::vector<FamilyFit> fits;  ///< the best by AIC first
  Given given = Given::size;    ///< in every likelihood of the fits: those of other data cannot be compared
};

/// The families that `--model` names: one, several between commas, or all of families(). Throws Error,
/// nearest names given.
/// @param known  that may be named: all_families(), or families(), those given the size
std::vector<const Family*> chosen_families(std::string_view names, std::span<const Family> known);

/// Why no family can be fitted to these counts: "40 tips, 2 orders"; empty where one can.
std::string too_few_to_fit(const OrderCounts& table);

/// Fits families to tables of stream counts (count_likelihood.hpp), one datum a tree; a second one of
/// families given the order (order_count_fit.hpp), where there are some.
///
/// A family that cannot be fitted at a size is listed with a note that says why. Throws Error where a table
/// is too small for any or holds counts that no binary tree has (OrderCounts::contradiction), Interrupted.
/// @param file  that the tables come from: what their names begin with
std::vector<FittedDatum> fit_order_counts(std::span<const OrderCounts> tables, std::string_view file,
                                          const ModelFitOptions& options, const Cancellation& cancellation);

/// The stream counts of trees, as a table of them would hold them.
std::vector<OrderCounts> order_counts_of(std::span<const RecordedTree> trees);

/// Fits families to whole trees by the exact likelihood of their splits (tree_fit.hpp), each by itself or,
/// where `pooled` is asked for, all together; then those given the order (order_fit.hpp), as data of their
/// own. Throws Error, Interrupted.
/// @param trees  binary
std::vector<FittedDatum> fit_whole_trees(std::span<const RecordedTree> trees, std::string_view file,
                                         bool pooled, const ModelFitOptions& options,
                                         const Cancellation& cancellation);

/// Fits families given the order to a table of the orders that meet (ObservedBiOrders::of_table), as to the
/// tree itself. Throws Error where a family is given n, or none can be fitted; Interrupted.
std::vector<FittedDatum> fit_bi_order_table(const ObservedBiOrders& observed, std::string_view file,
                                            const ModelFitOptions& options, const Cancellation& cancellation);

}  // namespace ramify
