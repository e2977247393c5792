#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/family/observed_bi_orders.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/model/ramification_matrix.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Families that are grown by order, fitted to whole trees by the exact likelihood of their nodes' bi-orders,
/// given the order of each root.
///
/// It is another likelihood than that given the number of nodes (tree_fit.hpp): the two cannot be compared,
/// and are ranked apart. A family that a tree is too small for has a note that names the smallest. Throws
/// Error for a tree that is not binary, Interrupted.
/// @param families  of Given::order
std::vector<TreeFit> fit_trees_given_order(std::span<const RecordedTree> trees,
                                           std::span<const Family* const> families,
                                           const TreeFitOptions& options, const Cancellation& cancellation);

/// The same of what was counted, of one tree or of several together.
TreeFit fit_bi_orders(std::string name, const ObservedBiOrders& observed,
                      std::span<const Family* const> families, const TreeFitOptions& options,
                      const Cancellation& cancellation);

/// One family. Of a ramification matrix the estimates are the shares of each row, p(k,0), ..., p(k,k), k = 1,
/// 2, ..., with multinomial errors and, for each, the profile interval of its row; of tokunaga a and c, by
/// search, with the misfit 2 (log L of the matrix - log L), of which the bootstrap knows the law.
FamilyFit fit_given_order(const Family& family, const ObservedBiOrders& observed);

/// Nothing where a family can be fitted; else why not.
std::string too_few_orders(const Family& family, const ObservedBiOrders& observed);

/// The matrix of the shares.
RamificationMatrix measured_matrix(const ObservedBiOrders& observed);

/// Trees of the fitted model with roots of the orders observed, each fitted as those were, into fit.bootstrap
/// and fit.goodness (bootstrap.hpp). Throws Interrupted.
void bootstrap_given_order(FamilyFit& fit, const ObservedBiOrders& observed, const BootstrapPlan& plan,
                           const Workforce& workforce, const Cancellation& cancellation);

}  // namespace ramify
