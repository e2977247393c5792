#pragma once

#include <span>
#include <string>

#include "ramify/fit/fit_row.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// The rows as a table: data,model,parameter,estimate,standard_error,lower,upper, then what they rest on:
/// n,n_source,estimator,observed,expected_at_rule,expected_at_rule_error,rule_low,rule_high,solution,solutions,
/// status,note. Six significant digits: more than the Monte Carlo errors leave.
Table fit_table(std::span<const FitRow> rows);

/// The same for reading: aligned columns, one heading for each datum and size, notes below.
std::string fit_text(std::span<const FitRow> rows);

}  // namespace ramify
