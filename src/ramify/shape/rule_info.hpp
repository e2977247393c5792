#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ramify {

/// A constant of a rule: its name, the interval it lies in, and what it is where it is left out.
struct RuleConstant {
  std::string_view name;
  double least, most;
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::optional<double> otherwise = {};
};

/// A rule of form as a file names it: "leaves_power" with its constants.
template <class Rule>
struct RuleInfo {
  std::string_view name;
  std::vector<RuleConstant> constants;
  std::string_view formula;
  std::string_view source;
  Rule (*make)(std::span<const double> constants);  ///< one for each, in their order
};

}  // namespace ramify
