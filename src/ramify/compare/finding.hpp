#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ramify/compare/evidence_kind.hpp"
#include "ramify/compare/interval.hpp"

namespace ramify {

/// A value with the name of what has it.
struct NamedValue {
  std::string name;
  double value;
};

/// What a claim says of a number.
enum class Relation { equals, at_most, at_least };

/// A sentence with a number in it, before anything is computed: a row of `ramify list claims`.
struct Statement {
  std::string part;    ///< "C20.2"
  std::string text;    ///< "E S_n ~ log_3 n, bst"
  std::string source;  ///< where it is claimed
  std::string convention;
  Relation relation = Relation::equals;
  std::string formula;  ///< of the theory value: "1/log 3"
  double theory;
  std::vector<NamedValue> rivals;     ///< values that somebody might believe: a verdict must exclude them
  std::optional<NamedValue> instead;  ///< of a statement that is known to be false: what holds
};

/// What is known of the number that a statement speaks of, and what that rests on.
struct Basis {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  EvidenceKind evidence;
  Standing standing;
  double estimate;
  Interval interval;  ///< of the true value: a bound, or where there is only that a sampling interval
  double largest_n;
  std::string method;            ///< estimator and how its interval is made
  std::string left_open;         ///< what would decide it where the interval does not
  double standard_error = none;  ///< of what was sampled
};

/// A limit by numbers that are taken to go on as they did: value +- bound.
inline Basis extrapolated(double value, double bound, double largest_n, std::string method,
                          std::string left_open = "larger sizes") {
  return {EvidenceKind::limit, Standing::extrapolated, value, {value - bound, value + bound}, largest_n,
          std::move(method),   std::move(left_open)};
}

struct Finding {
  Statement statement;
  Basis basis;
};

}  // namespace ramify
