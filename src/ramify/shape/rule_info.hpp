#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ramify/core/contract.hpp"
#include "ramify/core/find_named.hpp"

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

/// Several lists of rules as one.
template <class Rule>
std::vector<RuleInfo<Rule>> joined(std::initializer_list<std::vector<RuleInfo<Rule>>> lists) {
  std::vector<RuleInfo<Rule>> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// A rule by its name, with its constants; the last may be left out where they have a value of their own.
/// Throws Error for an unknown name.
template <class Rule>
Rule named_rule(const std::vector<RuleInfo<Rule>>& all, std::string_view name,
                std::span<const double> constants) {
  const RuleInfo<Rule>& info = find_named(all, &RuleInfo<Rule>::name, name, "rule");
  std::vector<double> values(constants.begin(), constants.end());
  while (values.size() < info.constants.size()) {
    RAMIFY_EXPECTS(info.constants[values.size()].otherwise);
    values.push_back(*info.constants[values.size()].otherwise);
  }
  return info.make(values);
}

}  // namespace ramify
