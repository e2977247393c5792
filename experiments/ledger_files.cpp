#include "ledger_files.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>
#include <vector>

#include "verdicts.hpp"
#include <fmt/format.h>

#include "ramify/core/parallel.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/page/html_writer.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

/// Files of claims that an earlier reproduction has left there must not pass for this one's.
void clear_claims(const fs::path& folder) {
  require_writable_folder(folder);
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".csv") fs::remove(entry.path(), ignored);
}

void write_claim(const ClaimOnPage& of, const fs::path& folder) {
  write_file_atomically(folder / fmt::format("{}.csv", of.claim.id), write_csv(verdict_table(of.verdicts)));
  if (of.plots.empty()) return;
  write_file_atomically(folder / fmt::format("{}_points.csv", of.claim.id),
                        write_csv(points_table(of.plots)));
}

}  // namespace

std::vector<NamedPlot> law_plots(const std::vector<const Claim*>& claims, GrowthLimits& limits,
                                 unsigned threads, const Cancellation& cancellation) {
  std::vector<std::vector<NamedPlot>> drawn(claims.size());
  parallel_for(claims.size(), threads, [&](std::size_t i, unsigned) {
    if (claims[i]->law_plots) drawn[i] = claims[i]->law_plots({limits, cancellation});
  });
  std::vector<NamedPlot> plots;
  for (auto& of_claim : drawn) std::ranges::move(of_claim, std::back_inserter(plots));
  return plots;
}

std::string write_ledger(const Reproduction& reproduction, std::vector<NamedPlot> plots,
                         const fs::path& folder) {
  require_writable_folder(folder / "plots");
  clear_claims(folder / "claims");
  const auto& verdicts = reproduction.judged.verdicts;
  write_file_atomically(folder / "verdicts.csv", write_csv(verdict_table(verdicts)));
  write_file_atomically(folder / "verdicts.txt", verdict_text(verdicts));
  const std::vector<FiledPlot> filed = file_plots(std::move(plots), folder / "plots");
  const std::vector<ClaimOnPage> claims = claims_on_page(reproduction, filed);
  for (const ClaimOnPage& of : claims) write_claim(of, folder / "claims");
  write_file_atomically(folder / "report.html", write_html(ledger_page(reproduction, claims)));
  return why_missing(filed);
}

}  // namespace ramify
