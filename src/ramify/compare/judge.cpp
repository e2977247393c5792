#include "ramify/compare/judge.hpp"

#include <algorithm>
#include <utility>

namespace ramify {
namespace {

bool keeps(const Statement& statement, const Interval& interval) {
  switch (statement.relation) {
    case Relation::at_most:
      return interval.upper <= statement.theory;
    case Relation::at_least:
      return interval.lower >= statement.theory;
    case Relation::equals:
      break;
  }
  return interval.contains(statement.theory);
}

bool breaks(const Statement& statement, const Interval& interval) {
  switch (statement.relation) {
    case Relation::at_most:
      return interval.lower > statement.theory;
    case Relation::at_least:
      return interval.upper < statement.theory;
    case Relation::equals:
      break;
  }
  return interval.lower > statement.theory || interval.upper < statement.theory;
}

}  // namespace

Decision judge(const Statement& statement, const Interval& interval) {
  if (breaks(statement, interval)) return Decision::refuted;
  const auto is_possible = [&](const NamedValue& rival) { return interval.contains(rival.value); };
  const bool excludes_rivals = std::ranges::none_of(statement.rivals, is_possible);
  return keeps(statement, interval) && excludes_rivals ? Decision::reproduced : Decision::inconclusive;
}

Statement with_rival(const Statement& statement, std::size_t rival) {
  Statement other = statement;
  std::swap(other.theory, other.rivals.at(rival).value);
  std::swap(other.formula, other.rivals.at(rival).name);
  return other;
}

}  // namespace ramify
