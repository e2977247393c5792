#include "verdicts.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ramify/io/text_writer.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {

void Evidence::add(const std::vector<const Claim*>& served, const std::vector<CheckedCell>& cells) {
  for (const auto* claim : served) {
    auto& mine = cells_[claim->id];
    mine.insert(mine.end(), cells.begin(), cells.end());
  }
  all_.insert(all_.end(), cells.begin(), cells.end());
}

std::vector<Verdict> Evidence::verdicts() const {
  std::vector<Verdict> all;
  for (const auto& claim : claims()) {
    const auto found = cells_.find(claim.id);
    if (found == cells_.end()) continue;
    for (auto& verdict : claim.judge(found->second)) all.push_back(std::move(verdict));
  }
  return all;
}

std::vector<NamedPlot> Evidence::plots() const {
  std::vector<NamedPlot> all;
  for (const auto& claim : claims()) {
    const auto found = cells_.find(claim.id);
    if (found == cells_.end()) continue;
    for (auto& plot : claim.plots(found->second)) all.push_back(std::move(plot));
  }
  return all;
}

std::optional<Evidence::WorstCheck> Evidence::worst_check() const {
  WorstCheck worst{0, "", 0};
  for (const auto& cell : all_) {
    for (std::size_t i = 0; i < cell.checks.size(); ++i) {
      if (!cell.checks[i]) continue;
      ++worst.checks;
      if (std::fabs(cell.checks[i]->z) < worst.z) continue;
      worst.z = std::fabs(cell.checks[i]->z);
      worst.where =
          fmt::format("{} of {} at n = {}", cell.result.columns[i].name, cell.result.model, cell.result.n);
    }
  }
  if (worst.checks == 0) return std::nullopt;
  return worst;
}

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

std::vector<std::string> changed_verdicts(const std::vector<Verdict>& verdicts,
                                          const std::filesystem::path& reference) {
  const CsvData committed = CsvData::read(reference);
  std::vector<std::string> changed;
  for (std::size_t row = 0; row < committed.rows(); ++row) {
    for (const auto& v : verdicts) {
      if (v.claim != committed.at(row, "claim") || to_string(v.outcome) == committed.at(row, "verdict"))
        continue;
      changed.push_back(
          fmt::format("{}: {}, was {}", v.claim, to_string(v.outcome), committed.at(row, "verdict")));
    }
  }
  return changed;
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

}  // namespace ramify
