#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/family/family.hpp"
#include "ramify/horton/model_ratios.hpp"
#include "ramify/measure/tree_measurement.hpp"

namespace ramify {

/// What the standard error of a ratio rests on.
enum class ErrorSource : std::uint8_t {
  none,
  law,      ///< covariances of stream counts of the fitted model, delta method
  trees,    ///< deviation over grown trees of the fitted model
  scatter,  ///< of the values about their regression: no model
  ratios,   ///< errors of the two ratios, taken as independent
};

/// One ratio, or Murray's exponent, of one tree by one estimator.
struct HortonRatio {
  std::string_view quantity;  ///< "R_B", "R_L", "R_D", "R_A", "murray_exponent"
  std::string estimator;      ///< "regression_inner"; "forks" of Murray's exponent fork by fork
  OrderSpan orders;           ///< that were read; 0..0 fork by fork
  double value;
  double standard_error;  ///< NaN where there is none
  ErrorSource error_from;
  double bias;                        ///< under the model; NaN where there is none
  std::vector<std::size_t> outlying;  ///< of R_B: k of M_k/M_(k+1); of means: k of the mean
  std::string note;
};

/// The ratios of one tree.
struct HortonLaws {
  std::string data;
  std::string model;                ///< fitted, with its parameter; empty where none could be
  double reference;                 ///< what a bias is from
  std::string_view reference_name;  ///< "limit": the law's limiting ratio; "pooled_means"
  std::uint64_t trees;              ///< grown
  std::vector<HortonRatio> ratios;
};

struct HortonOptions {
  std::vector<const Family*> families;  ///< of which the best by AIC says errors
  ModelTrees trees{400, 1996, 1};       ///< an error is then known to 4 %
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::function<void(double done, double total)> progress = {};  ///< in trees of the data; may be empty
};

/// The families of one parameter that a table of counts is fitted by if nothing is said.
std::vector<const Family*> one_parameter_families();

/// Horton's laws of measured trees: bifurcation ratio R_B (Horton 1945), ratios of the mean lengths,
/// diameters and drainage areas R_L, R_D, R_A where there are any, by every estimator (RatioKind) over every
/// range of orders (OrderRange), with standard errors; Murray's exponent x in R_B = R_D^x (C35).
///
/// R_B has its error and bias from the best of the families, fitted to the counts (fit_order_counts): bias
/// is the estimator's mean in trees of the fitted model less the model's limiting ratio
/// (horton_ratio_constant), or where that is not known the pooled ratio of its mean counts. Where no family
/// can be fitted (too small a tree, forks of three, counts that no binary tree has) the scatter about the
/// regression says the error, as it does of all other ratios, for which there is no model. Throws
/// Interrupted. Cost: a fit (about a second a family), and the trees (ModelRatios).
std::vector<HortonLaws> horton_laws(std::span<const MeasuredOrders> trees, const HortonOptions& options,
                                    const Cancellation& cancellation);

}  // namespace ramify
