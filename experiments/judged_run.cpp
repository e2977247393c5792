#include "judged_run.hpp"

#include "verdicts.hpp"

#include "ramify/io/atomic_file.hpp"
#include "ramify/io/csv_writer.hpp"

namespace ramify {
namespace {

void write_plots(const Evidence& evidence, const std::filesystem::path& folder) {
  for (const auto& named : evidence.plots()) write_plot(named.plot, folder, named.stem);
}

}  // namespace

RunOutcome run_and_judge(const RunConfig& config, const RunOptions& options, const Cancellation& cancellation,
                         Evidence& evidence) {
  RunOutcome outcome = run_experiment(config, options, cancellation);
  if (!outcome.finished) return outcome;
  evidence.add(config, outcome.checked);
  Evidence own(options.looks);
  own.add(config, outcome.checked);
  if (served_claims(config).empty()) return outcome;
  write_file_atomically(outcome.folder / "verdict.json", verdict_json(own.verdicts()));
  write_plots(own, outcome.folder / "plots");
  return outcome;
}

void write_verdicts(const Evidence& evidence, const std::filesystem::path& folder) {
  const auto verdicts = evidence.verdicts();
  require_writable_folder(folder / "plots");
  write_file_atomically(folder / "verdicts.csv", write_csv(verdict_table(verdicts)));
  write_plots(evidence, folder / "plots");
  write_file_atomically(folder / "verdicts.txt", verdict_text(verdicts));
}

}  // namespace ramify
