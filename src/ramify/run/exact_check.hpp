#pragma once

#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/run/run_tables.hpp"

namespace ramify {

/// A finished cell: its index in the plan and its result.
struct FinishedCell {
  std::size_t index;
  CellResult result;
};

/// The highest order (leaf order 0) whose counts have curves: plots show the ratios of the orders up to it.
inline constexpr std::size_t highest_drawn_order = 2;

/// Puts the exact finite-n mean and the z-score beside every sampled mean whose law is in reach
/// (large/finite_means.hpp); the workforce shares the models (run/plan_laws.hpp). The laws give the curves
/// too, from the smallest to the largest size of a model, of every statistic of one column and of the counts
/// to highest_drawn_order. Throws Interrupted when cancelled.
CheckedRun check_against_exact_laws(const Plan& plan, std::vector<FinishedCell> finished,
                                    const Workforce& workforce, const Cancellation& cancellation = {});

/// Helps another process to do so.
void help_check(const Plan& plan, const Workforce& workforce, const Cancellation& cancellation);

/// The same without any check: what a stopped run has time for.
std::vector<CheckedCell> unchecked(std::vector<FinishedCell> cells);

}  // namespace ramify
