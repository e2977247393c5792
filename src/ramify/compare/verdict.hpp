#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ramify {

/// What the experiment says of a claim. Undecided is an answer, not a failure.
enum class Outcome { reproduced, refuted, inconclusive };

std::string_view to_string(Outcome outcome);

/// One row of the verdict table.
struct Verdict {
  std::string claim;   ///< "C20.2"
  std::string source;  ///< where it is claimed
  std::string statement;
  std::string convention;  ///< what was counted, and from where
  double theory;           ///< the claimed value
  double estimate;
  double standard_error;  ///< sampling error alone
  double lower, upper;    ///< 99 % interval, widened by what finite-size bias is left
  std::uint64_t largest_n;
  Outcome outcome;
  std::string method;  ///< estimator, tolerance, and why an outcome is inconclusive
};

}  // namespace ramify
