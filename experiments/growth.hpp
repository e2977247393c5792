#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claim.hpp"

#include "ramify/compare/judge.hpp"
#include "ramify/estimate/slope.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// A claim of the form "the mean of a statistic grows like theory * log n", of one model.
struct GrowthClaim {
  std::string id;
  std::string source;
  std::string statement;
  std::string convention;
  StatisticColumn statistic;
  double theory;
  double tolerance;  ///< relative
  Approach approach;
  std::string why_drifts;  ///< said where it stays inconclusive
};

/// Sizes without which no growth is judged.
inline constexpr std::size_t growth_sizes = 4;

/// Means of a column over the sizes of a model. A standard error is at least 1/trees: a sample without spread
/// has not shown that there is none.
std::vector<SizedMean> means_of(const ModelCells& model, const StatisticColumn& column);

/// Judges it by the slope over the upper half of the sizes, growth_sizes or more.
Verdict judge_growth(const GrowthClaim& claim, const ModelCells& model);

/// A plot as a claim names it.
struct PlotNames {
  std::string_view stem, title, y_label;
};

/// A growth claim and the model that it is of.
struct GrowthCase {
  GrowthClaim claim;
  ModelCells model;
};

/// Mean against n with error bars and its exact curve, case by case, the growth law drawn through the last
/// point (its slope is the claim, its height is not).
NamedPlot growth_plot(const PlotNames& names, const std::vector<GrowthCase>& cases);

/// The same claim of every model, as data: lim E X_n / log n is a constant of the model.
struct GrowthLaw {
  std::string_view source;
  std::string_view statement;  ///< without the model
  std::string_view convention;
  std::optional<Constant> (*constant)(const Model&);
  double tolerance;  ///< relative
  Approach approach;
  std::string_view why_drifts;
};

/// A split tree of which the constant is known.
template <std::optional<Constant> (*constant)(const Model&)>
bool has(const Model& model) {
  return model.is_split() && constant(model).has_value();
}

/// The claim with a verdict and a series of its plot for every model, numbered C6.1, C6.2, ... in the order
/// of the configs.
/// @param claim  without judge and plots; speaks of models that have the constant
Claim growth_law_claim(Claim claim, const GrowthLaw& law, const PlotNames& plot);

}  // namespace ramify
