#include "verdicts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/io/text_writer.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {

namespace {

/// As many decimals as tell the ends of an interval apart, four at least.
int decimals_of(const Interval& interval) {
  const double width = interval.upper - interval.lower;
  constexpr int fewest = 4, most = 12;
  if (!(width > 0) || !std::isfinite(width)) return fewest;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(width))), fewest, most);
}

/// n, whole as far as it is printed whole.
Row& add_size(Row& row, double n) {
  return n < 0x1p53 && n == std::floor(n) ? row.whole(static_cast<std::uint64_t>(n)) : row.significant(n, 3);
}

}  // namespace

std::string_view to_string(Relation relation) {
  switch (relation) {
    case Relation::at_most:
      return "at most";
    case Relation::at_least:
      return "at least";
    case Relation::equals:
      break;
  }
  return "equals";
}

std::string_view claim_of(std::string_view name) {
  return name.substr(0, name.find_first_of("._"));
}

std::string interval_text(const Basis& basis) {
  const int decimals = decimals_of(basis.interval);
  return fmt::format("[{:.{}f}, {:.{}f}]", basis.interval.lower, decimals, basis.interval.upper, decimals);
}

std::string theory_text(const Finding& finding) {
  const auto& [statement, basis] = finding;
  const std::string relation =
      statement.relation == Relation::equals ? "" : fmt::format("{} ", to_string(statement.relation));
  return fmt::format("{}{:.{}f}", relation, statement.theory, decimals_of(basis.interval));
}

std::string sampler_text(const SamplerCheck& check) {
  if (check.means == 0) return std::string(check.word());
  return fmt::format("{}: {} means, {:.1f} s.e.", check.word(), check.means, check.worst_z);
}

std::string in_words(const std::vector<NamedValue>& values) {
  std::string text;
  for (const auto& [name, value] : values)
    text += fmt::format("{}{} ({:.7g})", text.empty() ? "" : "; ", name, value);
  return text;
}

Table verdict_table(const std::vector<Verdict>& verdicts) {
  Table table({"claim",         "source",  "statement",      "convention", "relation", "formula",
               "theory",        "rivals",  "instead",        "evidence",   "standing", "estimate",
               "lower",         "upper",   "standard_error", "largest_n",  "verdict",  "sampler",
               "sampled_means", "worst_z", "method"});
  for (const auto& [finding, decision, sampler] : verdicts) {
    const auto& [statement, basis] = finding;
    const int decimals = decimals_of(basis.interval);
    Row row;
    row.texts({statement.part, statement.source, statement.text, statement.convention,
               to_string(statement.relation), statement.formula})
        .summary(statement.theory)
        .text(in_words(statement.rivals))
        .text(statement.instead ? in_words({*statement.instead}) : "")
        .texts({to_string(basis.evidence), to_string(basis.standing)})
        .fixed(basis.estimate, decimals)
        .fixed(basis.interval.lower, decimals)
        .fixed(basis.interval.upper, decimals)
        .summary(basis.standard_error);
    add_size(row, basis.largest_n)
        .texts({to_string(decision), sampler.word()})
        .whole(sampler.means)
        .fixed(sampler.means > 0 ? sampler.worst_z : Basis::none, 2)
        .text(decision == Decision::inconclusive ? basis.method + "; what would decide it: " + basis.left_open
                                                 : basis.method);
    table.add(std::move(row));
  }
  return table;
}

std::string verdict_text(const std::vector<Verdict>& verdicts) {
  Table table({"claim", "statement", "theory", "true value lies in", "rests on", "sampler", "verdict"});
  for (const auto& [finding, decision, sampler] : verdicts) {
    const auto& [statement, basis] = finding;
    table.add(Row()
                  .text(statement.part)
                  .text(statement.text)
                  .text(theory_text(finding))
                  .text(interval_text(basis))
                  .text(fmt::format("{}, {}", to_string(basis.evidence), to_string(basis.standing)))
                  .text(sampler_text(sampler))
                  .text(to_string(decision)));
  }
  return write_text(table);
}

namespace {

/// A verdict of a committed table.
struct Committed {
  std::string part, statement, decision;

  bool is_of(const Verdict& verdict) const {
    const Statement& now = verdict.finding.statement;
    return part == now.part && statement == now.text;
  }
};

std::vector<Committed> read_committed(const std::filesystem::path& reference) {
  const CsvData table = CsvData::read(reference);
  std::vector<Committed> verdicts;
  for (std::size_t row = 0; row < table.rows(); ++row)
    verdicts.push_back({std::string(table.at(row, "claim")), std::string(table.at(row, "statement")),
                        std::string(table.at(row, "verdict"))});
  return verdicts;
}

}  // namespace

std::vector<std::string> changed_verdicts(const std::vector<Verdict>& verdicts,
                                          const std::filesystem::path& reference,
                                          const std::vector<std::string_view>& claims) {
  auto committed = read_committed(reference);
  std::erase_if(committed, [&](const Committed& old) {
    return !claims.empty() && std::ranges::find(claims, claim_of(old.part)) == claims.end();
  });
  std::vector<std::string> changed;
  for (const auto& old : committed) {
    const auto now = std::ranges::find_if(verdicts, [&](const Verdict& v) { return old.is_of(v); });
    if (now == verdicts.end())
      changed.push_back(fmt::format("{}: no verdict on '{}', was {}", old.part, old.statement, old.decision));
    else if (to_string(now->decision) != old.decision)
      changed.push_back(fmt::format("{}: {}, was {}", old.part, to_string(now->decision), old.decision));
  }
  for (const auto& v : verdicts)
    if (std::ranges::none_of(committed, [&](const Committed& old) { return old.is_of(v); }))
      changed.push_back(fmt::format("{}: {} on '{}', was not there", v.finding.statement.part,
                                    to_string(v.decision), v.finding.statement.text));
  return changed;
}

}  // namespace ramify
