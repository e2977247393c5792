#pragma once

#include <string>
#include <vector>

#include "ramify/report/plot.hpp"
#include "ramify/run/model_looks.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/run/run_tables.hpp"

namespace ramify {

/// The plots of a run and the names of their files: against n, a series for each model, the mean of each
/// statistic with a single column ("height") and its variance where a law is known ("height_variance"), and
/// where counts were asked for the ratios of the mean counts of neighbouring orders ("streams_ratio_1").
/// Exact curves lie beneath the sampled points. None where no model has two sizes.
/// @param plan   of the cells
/// @param looks  of its models
std::vector<NamedPlot> run_plots(const CheckedRun& run, const Plan& plan, const ModelLooks& looks);

/// The points of the exact mean of a column of a model, among all the curves; empty where there is none.
std::vector<PlotPoint> exact_means(const std::vector<ExactCurve>& curves, std::string_view model,
                                   const StatisticColumn& column);

}  // namespace ramify
