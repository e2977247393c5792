#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/fit/bootstrap.hpp"
#include "ramify/fit/count_likelihood.hpp"
#include "ramify/fit/family_fit.hpp"
#include "ramify/optimise/objective.hpp"

namespace ramify {

/// Trees with T_i = a c^(i-1) side branches i orders below, as counts of streams see them.
///
/// Of a tree of many orders sum over i of T_i M_(k+i) is nearly a/(R-c) M_k whatever the order k, R the
/// limiting Horton ratio: so counts fix R, and a and c apart by the highest orders alone. Searched are R > 2
/// and x = c/R in (0,1), a free pair with a = (R-2)(1-x) and c = x R (tokunaga_horton_ratio.hpp).
const Family& tokunaga_by_ratio();

/// a and c of R and x.
std::vector<double> tokunaga_of_ratio(std::span<const double> ratio_and_share);

/// Minus the log-likelihood of stream counts given the order S of the root, from the moments of what is new
/// at every order. Given the counts of the orders above,
///
///     e_k = M_k - 2 M_(k+1) - sum over j > k of T_(j-k) M_j
///
/// has mean 0: a stream of order j has side branches that are geometric in number, mean T_1 + ... + T_j, and
/// of independent orders, so that e_k and e_l, k <= l, have the covariance
/// sum over j > l of M_j (T_(j-k) T_(j-l) + T_(j-k) [k = l]), and 1/12 beside it (rounding_variance). The
/// density of e_k given e_(k+1), ... is taken to be Gaussian, and multiplied over the orders whose order
/// above has ObservedCounts::enough streams; the orders above are given. M_0 carries what the others do.
/// @param counts  of one order at least
Objective order_count_objective(const ObservedCounts& counts);

/// Of how many orders, from the tips up, the likelihood is.
std::size_t orders_given_above(const ObservedCounts& counts);

/// R and x with their errors, by that likelihood. A fit that too few orders carry has a note that says so.
FamilyFit fit_counts_given_order(const ObservedCounts& counts);

/// Trees of the fitted model with a root of the same order, each fitted as the counts were (bootstrap.hpp).
/// Throws Interrupted. Cost: some 40 ns a node.
void bootstrap_counts_given_order(FamilyFit& fit, const ObservedCounts& counts, const BootstrapPlan& plan,
                                  const Workforce& workforce, const Cancellation& cancellation);

}  // namespace ramify
