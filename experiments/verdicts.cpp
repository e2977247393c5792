#include "verdicts.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ramify/io/text_writer.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {

Table verdict_table(const std::vector<Verdict>& verdicts) {
  Table table({"claim", "source", "statement", "convention", "theory", "estimate", "standard_error", "lower",
               "upper", "largest_n", "verdict", "method"});
  for (const auto& v : verdicts)
    table.add(Row()
                  .text(v.claim)
                  .text(v.source)
                  .text(v.statement)
                  .text(v.convention)
                  .summary(v.theory)
                  .summary(v.estimate)
                  .summary(v.standard_error)
                  .summary(v.lower)
                  .summary(v.upper)
                  .whole(v.largest_n)
                  .text(to_string(v.outcome))
                  .text(v.method));
  return table;
}

std::string verdict_text(const std::vector<Verdict>& verdicts) {
  Table table({"claim", "statement", "theory", "estimate [99 % interval]", "largest n", "verdict"});
  for (const auto& v : verdicts)
    table.add(Row()
                  .text(v.claim)
                  .text(v.statement)
                  .fixed(v.theory, 4)
                  .text(fmt::format("{:.4f} [{:.4f}, {:.4f}]", v.estimate, v.lower, v.upper))
                  .whole(v.largest_n)
                  .text(to_string(v.outcome)));
  return write_text(table);
}

std::string verdict_json(const std::vector<Verdict>& verdicts) {
  auto all = nlohmann::ordered_json::array();
  for (const auto& v : verdicts)
    all.push_back({{"claim", v.claim},
                   {"source", v.source},
                   {"statement", v.statement},
                   {"convention", v.convention},
                   {"theory", v.theory},
                   {"estimate", v.estimate},
                   {"standard_error", v.standard_error},
                   {"lower", v.lower},
                   {"upper", v.upper},
                   {"largest_n", v.largest_n},
                   {"verdict", to_string(v.outcome)},
                   {"method", v.method}});
  return all.dump(2) + "\n";
}

namespace {

/// A verdict of a committed table.
struct Committed {
  std::string claim, statement, outcome;

  bool is_of(const Verdict& verdict) const {
    return claim == verdict.claim && statement == verdict.statement;
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
                                          const std::filesystem::path& reference, Compared compared) {
  const auto committed = read_committed(reference);
  std::vector<std::string> changed;
  for (const auto& old : committed) {
    const auto now = std::ranges::find_if(verdicts, [&](const Verdict& v) { return old.is_of(v); });
    if (now == verdicts.end()) {
      if (compared == Compared::all)
        changed.push_back(
            fmt::format("{}: no verdict on '{}', was {}", old.claim, old.statement, old.outcome));
    } else if (to_string(now->outcome) != old.outcome) {
      changed.push_back(fmt::format("{}: {}, was {}", now->claim, to_string(now->outcome), old.outcome));
    }
  }
  if (compared == Compared::those_in_both) return changed;
  for (const auto& v : verdicts)
    if (std::ranges::none_of(committed, [&](const Committed& old) { return old.is_of(v); }))
      changed.push_back(
          fmt::format("{}: {} on '{}', was not there", v.claim, to_string(v.outcome), v.statement));
  return changed;
}

}  // namespace ramify
