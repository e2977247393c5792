#include "ramify/run/run_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/version.hpp"
#include "ramify/io/readable.hpp"
#include "ramify/page/shell_word.hpp"
#include "ramify/sample/graft_rule.hpp"
#include "ramify/text/remarks.hpp"

namespace ramify {
namespace {

/// "84 sampled means ... the worst is 2.1 standard errors off (strahler of bst at n = 300)."
std::string check_words(const std::vector<CheckedCell>& cells) {
  std::size_t means = 0;
  double worst = 0;
  std::string where;
  for (const CheckedCell& cell : cells)
    for (std::size_t i = 0; i < cell.checks.size(); ++i) {
      if (!cell.checks[i]) continue;
      ++means;
      if (const double z = std::abs(cell.checks[i]->z); z >= worst) {
        worst = z;
        where = fmt::format("{} of {} at n = {}", cell.result.columns[i].column.name(), cell.result.model,
                            cell.result.n);
      }
    }
  if (means == 0) return "No exact law is in reach of what was sampled: its means stand alone.";
  return fmt::format(
      "Held against exact finite-n laws: {}, of which the worst lies {:.1f} standard errors off ({}).",
      counted(means, "sampled mean"), worst, where);
}

std::vector<PageBlock> lead_of(const RunConfig& config, const Plan& plan, const CheckedRun& run) {
  std::string words =
      fmt::format("What {} says, grown and measured: {} of random trees, {} in all, seed {}. {}",
                  file_name(config), counted(plan.cells.size(), "cell"), counted(total_trees(plan), "tree"),
                  plan.seed, check_words(run.cells));
  return {PageParagraph{std::move(words)}};
}

PageSection cells_section(const Plan& plan, const CheckedRun& run) {
  Table table({"cell", "model", "n", "trees", "worst |z|", "how trees are sampled"});
  for (const CheckedCell& checked : run.cells) {
    const Cell& cell = plan.cells[checked.number - 1];
    table.add(Row()
                  .whole(checked.number)
                  .text(cell.model.text())
                  .whole(cell.n)
                  .whole(cell.replicates)
                  .fixed(checked.worst_z().value_or(ColumnSummary::none), 1)
                  .text(GraftRule(cell.model, plan.method).describe(cell.n)));
  }
  return {
      "Cells",
      {PageTable{"A model and a size each; worst |z|: the most standard errors that a mean of the cell lies "
                 "off its exact law",
                 readable(table)}},
      {}};
}

PageSection pictures_section(const std::vector<FiledPlot>& plots) {
  PageSection section{"Pictures", {}, {}};
  for (const FiledPlot& plot : plots) section.blocks.push_back(figure_of(plot));
  if (plots.empty())
    section.blocks.emplace_back(PageParagraph{"No model has two sizes: there is nothing to draw."});
  return section;
}

/// The table as a page shows it, with the file that has all of it in its caption.
PageTable shown(const Table& table, std::string_view file, std::string_view caption) {
  if (table.rows() <= most_shown_rows) return {fmt::format("{} ({})", caption, file), readable(table)};
  Table first(table.columns());
  for (std::size_t r = 0; r < most_shown_rows; ++r) {
    Row row;
    for (const Field& field : table.row(r)) row.field(field);
    first.add(std::move(row));
  }
  return {fmt::format("{}: the first {} of {} rows; all stand in {}", caption, most_shown_rows, table.rows(),
                      file),
          readable(first)};
}

PageSection tables_section(const CheckedRun& run) {
  PageSection section{"Tables", {}, {}};
  section.blocks.emplace_back(shown(
      summary_table(run.cells), "summary.csv",
      "Every statistic of every cell; z: standard errors between the mean and the exact mean at the same n"));
  if (const Table orders = orders_table(run.cells); orders.rows() > 0)
    section.blocks.emplace_back(
        shown(orders, "orders.csv", "Nodes and streams of every order, which counts from 0 at the leaves"));
  return section;
}

PageSection provenance_section(const RunConfig& config) {
  return {
      "Provenance",
      {PageParagraph{fmt::format("Made by ramify {}, seed {}, from {}; nothing else decides a number. "
                                 "Compiler, host, threads and times stand in provenance.json.",
                                 version, config.seed, file_name(config))},
       PageVerbatim{file_name(config), config.text}, PageParagraph{"The whole run again:"},
       PageCommands{{fmt::format("ramify run {} --seed {}", shell_word(file_name(config)), config.seed)}}},
      {}};
}

}  // namespace

Page run_page(const RunConfig& config, const Plan& plan, const CheckedRun& run,
              const std::vector<FiledPlot>& plots) {
  return {
      fmt::format("Run of {}", file_name(config)),
      lead_of(config, plan, run),
      {cells_section(plan, run), pictures_section(plots), tables_section(run), provenance_section(config)},
      {}};
}

}  // namespace ramify
