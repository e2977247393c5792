#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "claim.hpp"

#include "ramify/compare/judge.hpp"
#include "ramify/estimate/slope.hpp"

namespace ramify {

/// A claim of the form "the mean of a statistic grows like theory * log n".
struct GrowthClaim {
  std::string id;
  std::string source;
  std::string statement;
  std::string convention;
  std::string model;      ///< as written in the config
  std::string statistic;  ///< column
  double theory;
  double tolerance;  ///< relative
  Approach approach;
  std::string why_drifts;  ///< said where it stays inconclusive
};

/// The cells of one model, smallest n first.
std::vector<CheckedCell> cells_of(const std::vector<CheckedCell>& cells, std::string_view model);

/// Means of a column over the sizes of one model. A standard error is at least 1/trees: a sample without
/// spread has not shown that there is none.
std::vector<SizedMean> means_of(const std::vector<CheckedCell>& cells, std::string_view model,
                                const std::string& column);

/// "means within 2.1 standard errors of the exact ones at n = 100..1000", or that no exact law was in reach.
std::string exact_note(const std::vector<CheckedCell>& cells, std::string_view model,
                       const std::string& column);

/// Judges each by the slope over the upper half of its sizes; leaves out a claim with fewer than four sizes
/// of its model.
std::vector<Verdict> judge_growth(const std::vector<GrowthClaim>& claims,
                                  const std::vector<CheckedCell>& cells);

/// Mean against n with error bars, the growth law drawn through the last point (its slope is the claim, its
/// height is not).
std::vector<PlotSeries> growth_series(const GrowthClaim& claim, const std::vector<CheckedCell>& cells);

/// One plot of several such claims.
Plot growth_plot(const std::string& title, const std::string& y_label, const std::vector<GrowthClaim>& claims,
                 const std::vector<CheckedCell>& cells);

}  // namespace ramify
