#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// How a parameter came out.
enum class FitStatus {
  computed,  ///< a formula, nothing fitted: the rule p = 1/R, Murray's exponent
  converged,
  no_solution,    ///< no p in the range has that expected ratio at this n
  undetermined,   ///< every p has it: the data say nothing of p
  not_converged,  ///< the solver failed (exit code 3)
};

/// "converged"
std::string_view status_name(FitStatus status);

/// One parameter of one datum at one size; NaN where there is no such number.
struct FitRow {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::string data;
  std::string model;
  std::string parameter;  ///< "p_rule", "p", "p_streams_regression", ..., "murray_exponent"
  double estimate = none;
  double standard_error =
      none;  ///< Monte Carlo error of the estimate: of the computation, not of the measurement
  double lower =
      none;  ///< all p between lower and upper have the observed ratio in the central 95 % of their trees
  double upper = none;
  Size n = 0;             ///< 0: unknown
  std::string n_source;   ///< "printed", "counted", "portion", "horton", "user", "unknown"
  std::string estimator;  ///< of the bifurcation ratio; "" where none is meant
  double observed = none;
  double expected_at_rule = none;  ///< the estimator's mean over trees of p = 1/R
  double expected_at_rule_error = none;
  double rule_low = none;  ///< central 95 % of the estimator over trees of p = 1/R
  double rule_high = none;
  std::size_t solution = 0;  ///< 1 of `solutions`, ascending p; 0 where none was looked for or found
  std::size_t solutions = 0;
  FitStatus status = FitStatus::computed;
  std::string note;
};

/// True where a row did not converge.
bool any_not_converged(std::span<const FitRow> rows);

}  // namespace ramify
