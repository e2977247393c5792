#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/family/family.hpp"
#include "ramify/optimise/profile.hpp"

namespace ramify {

/// A fitted parameter with its errors.
struct FittedParameter {
  std::string_view name;
  double estimate;
  double standard_error;  ///< from the curvature of the log-likelihood; NaN where it has none, as at an end
  double lower, upper;    ///< profile interval, 95 %; NaN where the fit did not converge
  bool lower_open, upper_open;  ///< the likelihood does not fall so far: nothing bounds the parameter there
};

/// How far an observation lies from the fitted model.
struct Goodness {
  double statistic;     ///< what the observation names: NaN where it has none
  double p_value;       ///< P(a larger one) under the fitted model
  std::uint64_t trees;  ///< of the parametric bootstrap that gave it; 0: chi-square, of so many
  double degrees;       ///< degrees of freedom
};

/// Estimates of trees of the fitted model, each fitted like the observation.
struct BootstrapEstimate {
  double lower, upper;  ///< 2.5 and 97.5 % of them
  double bias;          ///< their mean minus the estimate
  double deviation;     ///< their standard deviation
};

/// Whether a simpler family suffices, one without parameters that the fitted one holds (nested_test.hpp).
struct NestedTest {
  const Family* simpler;
  double likelihood_ratio;  ///< 2 (log L of the larger - log L of the simpler)
  double p_value;           ///< P(a larger one) where the simpler is true: small, and it does not suffice
  std::uint64_t trees;      ///< of the simpler family, that gave it
};

/// A pair of shapes on the valley of equivalent pairs (valley.hpp).
struct ValleyPoint {
  enum class Place {
    between,
    estimate,
    end,       ///< of the 95 % region
    open_end,  ///< of what is searched: the region goes on
  };
  double a, b;
  double log_likelihood;
  double horton_ratio;  ///< R(a,b); NaN where it is out of reach
  Place place;
};

/// One family fitted to one observation by maximum likelihood.
struct FamilyFit {
  const Family* family;
  std::vector<FittedParameter> parameters;
  double log_likelihood;
  double observations;  ///< what BIC counts: internal nodes
  bool converged;
  bool at_end;  ///< the likelihood rises towards the end of what is searched
  std::vector<std::vector<double>> other_optima;  ///< parameters of lower maxima, the highest first
  std::vector<double> covariance;      ///< of the searched numbers, row by row; empty where there is none
  std::vector<Point> searched_places;  ///< the estimate, the intervals' ends and other optima, as searched
  Goodness goodness;
  std::vector<BootstrapEstimate> bootstrap;     ///< of every parameter; empty without
  std::optional<FittedParameter> horton_ratio;  ///< limiting_ratio.hpp, where that was asked for and exists
  std::string note;
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  std::vector<NestedTest> simpler = {};  ///< with a bootstrap
  std::vector<ValleyPoint> valley = {};  ///< of two shapes, where that was asked for; by ascending a+b
  // NOLINTEND(readability-redundant-member-init)
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::size_t dependent = 0;  ///< parameters that the others give, as where some sum to 1

  double aic() const;
  double bic() const;
  std::vector<double> estimates() const;
};

/// A fit before it is made: no parameters, no likelihood.
FamilyFit without_fit(const Family& family, double observations);

/// Maximises a likelihood over the whole domain of a family: from all its starts, the best optimum with
/// standard errors and profile intervals, the others listed.
/// @param minus_log_likelihood  of the searched numbers, in search_box(family)
FamilyFit fit_family(const Family& family, const Objective& minus_log_likelihood, double observations);

/// The searched numbers at which the likelihood is largest, alone: what a bootstrap needs of every tree.
/// Those of the fit where there are none.
/// @param start  where to begin: the estimate that the tree was grown with
Point best_place(const Family& family, const Objective& minus_log_likelihood, const Point& start);

/// The point, on the scale that is searched, that stands for it among those that nobody can tell apart
/// (Family::mirror).
Point folded(const Family& family, Point at);

/// Ranks fits: by AIC, those without a likelihood last.
void rank(std::vector<FamilyFit>& fits);

/// The ends of what is searched, on its scale.
struct SearchBox {
  Point low, high;
};
SearchBox search_box(const Family& family);

}  // namespace ramify
