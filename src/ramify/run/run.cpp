#include "ramify/run/run.hpp"

#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ramify/core/provenance.hpp"
#include "ramify/io/atomic_file.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/page/html_writer.hpp"
#include "ramify/report/filed_plot.hpp"
#include "ramify/run/block_store.hpp"
#include "ramify/run/exact_check.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/run/run_page.hpp"
#include "ramify/run/run_plots.hpp"
#include "ramify/run/runner.hpp"
#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

using CellBook = std::map<std::size_t, CellResult>;  ///< by place in the plan

std::vector<FinishedCell> finished(const CellBook& book) {
  std::vector<FinishedCell> cells;
  for (const auto& [index, result] : book) cells.push_back({index, result});
  return cells;
}

/// The store of a work folder; where it has none, a copy of the one that a finished run left.
BlockStore open_store(const fs::path& work, const RunOptions& options, const Plan& plan) {
  const fs::path file = work / BlockStore::file_name, earlier = options.folder / BlockStore::file_name;
  if (options.kept == KeptCells::take_over && !fs::exists(file) && fs::exists(earlier))
    fs::copy_file(earlier, file);
  return BlockStore(file, plan);
}

/// What lay in the work folder already.
void say_kept(const BlockStore& store, const RunOptions& options) {
  if (!options.say) return;
  if (store.set_aside())
    options.say(
        fmt::format("the store of the stopped run is damaged, or none of ramify's: it is kept as '{}', and "
                    "the run begins anew",
                    store.set_aside()->string()));
  if (const KeptWork kept = store.kept(); !kept.none())
    options.say(fmt::format("{} are kept from an earlier run", to_string(kept)));
}

/// All cells beside their exact laws; nothing where the user stopped it meanwhile.
std::optional<CheckedRun> checked_cells(const Plan& plan, const CellBook& book, const Workforce& workforce,
                                        const Cancellation& cancellation) {
  try {
    return check_against_exact_laws(plan, finished(book), workforce, cancellation);
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

/// Grows what the store has not. Nothing where it was stopped.
std::optional<CheckedRun> grow(const Plan& plan, const fs::path& work, const RunOptions& options,
                               const Cancellation& cancellation, CellBook& book) {
  BlockStore store = open_store(work, options, plan);
  say_kept(store, options);
  RunObserver observer;
  observer.cell_done = [&](std::size_t index, const CellResult& result) { book[index] = result; };
  if (options.progress)
    observer.progress = [&, total = estimate_work(plan, 1).nodes](double done) {
      options.progress(done, total);
    };
  if (!run_cells(plan, store, options.workforce, cancellation, observer)) return std::nullopt;
  return checked_cells(plan, book, options.workforce, cancellation);
}

nlohmann::ordered_json provenance_of(const RunConfig& config, const RunOptions& options,
                                     const Provenance& process) {
  return {{"program", "ramify"},
          {"version", process.version},
          {"schema", process.schema},
          {"config", config.path},
          {"config_text", config.text},
          {"seed", config.seed},
          {"compiler", process.compiler},
          {"host", process.host},
          {"threads", options.workforce.threads},
          {"processes", options.workforce.processes()},
          {"started", process.started}};
}

/// How the trees of each cell are sampled.
nlohmann::ordered_json sampled(const Plan& plan) {
  auto cells = nlohmann::ordered_json::array();
  for (const auto& cell : plan.cells)
    cells.push_back({{"model", cell.model.text()},
                     {"n", cell.n},
                     {"method", GraftRule(cell.model, plan.method).describe(cell.n)}});
  return cells;
}

void write_tables(const fs::path& folder, const std::vector<CheckedCell>& cells) {
  write_file_atomically(folder / "summary.csv", write_csv(summary_table(cells)));
  write_file_atomically(folder / "histograms.csv", write_csv(histograms_table(cells)));
  write_file_atomically(folder / "orders.csv", write_csv(orders_table(cells)));
}

/// Plots and page. Says why pictures are missing; nothing where all were drawn.
std::string write_report(const fs::path& folder, const RunConfig& config, const Plan& plan,
                         const CheckedRun& run, ModelLooks looks) {
  looks.add(config);
  const std::vector<FiledPlot> plots = file_plots(run_plots(run, plan, looks), folder / "plots");
  write_file_atomically(folder / "report.html", write_html(run_page(config, plan, run, plots)));
  return why_missing(plots);
}

/// Into the folder where the outcome lies.
void write_provenance(nlohmann::ordered_json provenance, double seconds, const Plan& plan,
                      const RunOutcome& outcome) {
  provenance["duration_seconds"] = seconds;
  provenance["sampled"] = sampled(plan);
  provenance["cells"] = fmt::format("{} of {}", outcome.checked.cells.size(), plan.cells.size());
  provenance["status"] = outcome.finished ? "complete" : "interrupted: only the cells listed are complete";
  write_file_atomically(outcome.folder / "provenance.json", provenance.dump(2) + "\n");
}

}  // namespace

RunOutcome run_experiment(const RunConfig& config, const RunOptions& options,
                          const Cancellation& cancellation) {
  const Provenance process = current_provenance();
  const auto begin = std::chrono::steady_clock::now();
  const Plan plan = make_plan(config);
  const WorkFolder work_folder(options.folder, options.kept);
  const fs::path& work = work_folder.path();
  require_writable_folder(work / "plots");
  CellBook book;
  auto checked = grow(plan, work, options, cancellation, book);

  // A stopped run has two seconds to put its things away: no laws, no plots.
  RunOutcome outcome{checked ? std::move(*checked) : CheckedRun{unchecked(finished(book))},
                     checked.has_value(), work};
  write_tables(work, outcome.checked.cells);
  if (outcome.finished)
    outcome.no_pictures = write_report(work, config, plan, outcome.checked, options.looks);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  write_provenance(provenance_of(config, options, process), seconds.count(), plan, outcome);
  if (!outcome.finished) return outcome;
  work_folder.move_into_place();
  outcome.folder = options.folder;
  return outcome;
}

void help_run_experiment(const RunConfig& config, const Workforce& workforce,
                         const Cancellation& cancellation) {
  const Plan plan = make_plan(config);
  help_run_cells(plan, workforce, cancellation);
  help_check(plan, workforce, cancellation);
}

}  // namespace ramify
