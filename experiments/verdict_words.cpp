#include "verdict_words.hpp"

#include <algorithm>
#include <utility>

#include "verdicts.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/compare/judge.hpp"

namespace ramify {
namespace {

std::string_view evidence_words(EvidenceKind kind) {
  switch (kind) {
    case EvidenceKind::exact:
      return "laws or enumeration at finite n";
    case EvidenceKind::limit:
      return "exact laws at growing n";
    case EvidenceKind::sampled:
      return "sampled trees";
    case EvidenceKind::fitted:
      return "the parameters of a fitted model";
    case EvidenceKind::measured:
      return "trees of nature";
    case EvidenceKind::published:
      break;
  }
  return "printed numbers of a source";
}

std::string_view standing_words(Standing standing) {
  switch (standing) {
    case Standing::proved:
      return "up to the error bounds of the computation there is nothing left to believe";
    case Standing::extrapolated:
      return "the numbers are taken to go on as they did";
    case Standing::seen:
      break;
  }
  return "it is what was seen, and no more";
}

std::string known_sentence(const Basis& basis) {
  return fmt::format("The number lies in {}; that rests on {}, and {}.", interval_text(basis),
                     evidence_words(basis.evidence), standing_words(basis.standing));
}

/// How far a value lies outside; 0 within.
double distance(const Interval& interval, double value) {
  return std::max({0.0, interval.lower - value, value - interval.upper});
}

/// "4.2 of its widths above"
std::string place_words(const Interval& interval, double value) {
  const double off = distance(interval, value), width = interval.upper - interval.lower;
  const std::string how_far =
      width > 0 ? fmt::format("{:.3g} of its widths", off / width) : fmt::format("{:.3g}", off);
  return fmt::format("{} {}", how_far, value < interval.lower ? "below" : "above");
}

std::vector<std::string> possible_rivals(const Statement& statement, const Interval& interval) {
  std::vector<std::string> possible;
  for (const NamedValue& rival : statement.rivals)
    if (interval.contains(rival.value)) possible.push_back(rival.name);
  return possible;
}

std::string theory_words(const Statement& statement) {
  const std::string value = fmt::format("{:.7g}", statement.theory);
  return statement.formula == value ? value : fmt::format("{} ({})", statement.formula, value);
}

std::string_view rivals_excluded(const Statement& statement) {
  switch (statement.rivals.size()) {
    case 0:
      return "";
    case 1:
      return ", and excludes the rival";
    default:
      return ", and excludes every rival";
  }
}

std::string undecided(const Statement& statement, const Basis& basis) {
  const auto possible = possible_rivals(statement, basis.interval);
  const std::string why = possible.empty()
                              ? std::string("It lies on both sides of the bound")
                              : fmt::format("It holds rivals too: {}", fmt::join(possible, "; "));
  return fmt::format("{}, so the verdict is inconclusive; what would decide it: {}.", why, basis.left_open);
}

/// What the one rule (compare/judge.hpp) makes of the interval.
std::string rule_sentence(const Verdict& verdict) {
  const auto& [statement, basis] = verdict.finding;
  const bool is_bound = statement.relation != Relation::equals;
  const std::string theory = theory_words(statement);
  switch (verdict.decision) {
    case Decision::inconclusive:
      return undecided(statement, basis);
    case Decision::refuted:
      return is_bound ? fmt::format("All of it breaks the bound, {} {}: refuted.",
                                    to_string(statement.relation), theory)
                      : fmt::format("The theory, {}, lies {} it: refuted.", theory,
                                    place_words(basis.interval, statement.theory));
    case Decision::reproduced:
      break;
  }
  return is_bound
             ? fmt::format("All of it keeps the bound, {} {}{}: reproduced.", to_string(statement.relation),
                           theory, rivals_excluded(statement))
             : fmt::format("It contains the theory, {}{}: reproduced.", theory, rivals_excluded(statement));
}

std::string sampler_sentence(const SamplerCheck& check) {
  if (!check.takes_trees)
    return "It speaks of no sampled trees, so there is no sampler to hold against a law.";
  if (check.means == 0)
    return "No config of this run samples its trees: the sampler was not held against the exact law here.";
  return fmt::format(
      "Apart from that the sampler was held against the exact law: of {} means the worst lies {:.1f} "
      "standard "
      "errors off, where {:.1f} are allowed{}.",
      check.means, check.worst_z, check.allowed_z, check.failed() ? ", so the sampler FAILED" : "");
}

/// A value in the theory's place.
struct Control {
  std::string role, name;
  double value;
  Statement statement;
};

std::vector<Control> controls_of(const Statement& statement) {
  std::vector<Control> controls;
  for (std::size_t i = 0; i < statement.rivals.size(); ++i)
    controls.push_back(
        {"rival", statement.rivals[i].name, statement.rivals[i].value, with_rival(statement, i)});
  if (statement.instead) {
    Statement other = statement;
    other.theory = statement.instead->value;
    other.formula = statement.instead->name;
    controls.push_back(
        {"holds instead", statement.instead->name, statement.instead->value, std::move(other)});
  }
  return controls;
}

}  // namespace

std::string how_reached(const Verdict& verdict) {
  return fmt::format("{} {} {}", known_sentence(verdict.finding.basis), rule_sentence(verdict),
                     sampler_sentence(verdict.sampler));
}

Table control_table(const std::vector<Verdict>& verdicts) {
  Table table({"part", "in the theory's place", "which is", "value", "outside by", "in widths",
               "verdict then", "power"});
  for (const Verdict& verdict : verdicts) {
    const Interval& interval = verdict.finding.basis.interval;
    const bool has_chance = verdict.finding.basis.evidence == EvidenceKind::sampled;
    for (const auto& [role, name, value, statement] : controls_of(verdict.finding.statement)) {
      const double off = distance(interval, value);
      Row row;
      row.text(statement.part).text(name).text(role).summary(value).significant(off, 4);
      if (const double width = interval.upper - interval.lower; width > 0)
        row.significant(off / width, 3);
      else
        row.nothing();
      const Decision then = judge(statement, interval);
      row.text(to_string(then));
      if (has_chance)
        row.nothing();
      else
        row.whole(then == Decision::reproduced ? 0 : 1);
      table.add(std::move(row));
    }
  }
  return table;
}

}  // namespace ramify
