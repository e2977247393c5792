#include "judged_run.hpp"

#include "verdicts.hpp"

#include "ramify/io/atomic_file.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/report/filed_plot.hpp"

namespace ramify {
RunOutcome run_and_judge(const RunConfig& config, const RunOptions& options, const Cancellation& cancellation,
                         Ledger& ledger, GrowthLimits& limits) {
  RunOutcome outcome = run_experiment(config, options, cancellation);
  if (!outcome.finished) return outcome;
  ledger.add(config, outcome.checked);
  Ledger own(options.looks);
  own.add(config, outcome.checked);
  if (own.served().empty()) return outcome;
  const auto judged = own.judged(own.served(), limits, options.workforce.threads, cancellation);
  write_file_atomically(outcome.folder / "verdicts.csv", write_csv(verdict_table(judged.verdicts)));
  if (outcome.no_pictures.empty())
    outcome.no_pictures = why_missing(file_plots(own.plots(), outcome.folder / "plots"));
  return outcome;
}

}  // namespace ramify
