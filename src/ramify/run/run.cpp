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
#include "ramify/run/cell_store.hpp"
#include "ramify/run/exact_check.hpp"
#include "ramify/run/plan.hpp"
#include "ramify/run/run_plots.hpp"
#include "ramify/run/runner.hpp"
#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

/// The cells of a run, some of them loaded from an earlier one.
class CellBook {
 public:
  CellBook(const Plan& plan, const fs::path& folder)
      : plan_(plan), store_(folder, plan), wanted_(plan.cells.size(), true) {}

  void take_over(const CellStore& earlier) {
    for (std::size_t i = 0; i < plan_.cells.size(); ++i) {
      if (auto cell = earlier.load(i)) keep(i, std::move(*cell));
    }
  }

  void keep(std::size_t index, CellResult result) {
    store_.save(index, result);
    wanted_[index] = false;
    done_[index] = std::move(result);
  }

  const std::vector<bool>& wanted() const { return wanted_; }

  std::vector<FinishedCell> finished() const {
    std::vector<FinishedCell> cells;
    for (const auto& [index, result] : done_) cells.push_back({index, result});
    return cells;
  }

 private:
  const Plan& plan_;
  CellStore store_;
  std::vector<bool> wanted_;
  std::map<std::size_t, CellResult> done_;
};

/// All cells beside their exact laws; nothing where the user stopped it meanwhile.
std::optional<CheckedRun> checked_cells(const Plan& plan, const CellBook& book, unsigned threads,
                                        const Cancellation& cancellation) {
  try {
    return check_against_exact_laws(plan, book.finished(), threads, cancellation);
  } catch (const Interrupted&) {
    return std::nullopt;
  }
}

nlohmann::ordered_json provenance_of(const RunConfig& config, const RunOptions& options,
                                     const Provenance& process) {
  return {{"program", "ramify"},          {"version", process.version}, {"schema", process.schema},
          {"config", config.path},        {"config_text", config.text}, {"seed", config.seed},
          {"compiler", process.compiler}, {"host", process.host},       {"threads", options.threads},
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

void write_plots(const fs::path& folder, const std::vector<std::pair<std::string, Plot>>& plots) {
  for (const auto& [stem, plot] : plots) write_plot(plot, folder, stem);
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
  require_writable_folder(work / "cells");
  require_writable_folder(work / "plots");
  CellBook book(plan, work / "cells");
  if (options.kept == KeptCells::take_over) {
    book.take_over(CellStore(options.folder / "cells", plan));
    book.take_over(CellStore(work / "cells", plan));
  }
  RunObserver observer;
  observer.cell_done = [&](std::size_t index, const CellResult& result) { book.keep(index, result); };
  if (options.progress)
    observer.progress = [&, total = estimate_work(plan, 1).nodes](double done) {
      options.progress(done, total);
    };
  std::vector<bool> wanted = book.wanted();
  const bool grown = run_cells(plan, wanted, options.threads, cancellation, observer);
  auto checked = grown ? checked_cells(plan, book, options.threads, cancellation) : std::nullopt;

  // A stopped run has two seconds to put its things away: no laws, no plots.
  RunOutcome outcome{checked ? std::move(*checked) : CheckedRun{unchecked(book.finished())},
                     checked.has_value(), work};
  write_tables(work, outcome.checked.cells);
  if (outcome.finished) {
    ModelLooks looks = options.looks;
    looks.add(config);
    write_plots(work / "plots", run_plots(outcome.checked, plan, looks));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  write_provenance(provenance_of(config, options, process), seconds.count(), plan, outcome);
  if (!outcome.finished) return outcome;
  work_folder.move_into_place();
  outcome.folder = options.folder;
  return outcome;
}

}  // namespace ramify
