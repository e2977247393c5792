#include <memory>
#include <variant>

#include "reading.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/measure/horton_plot.hpp"
#include "ramify/measure/measure_files.hpp"

namespace ramify::cli {
namespace {

struct MeasureArguments {
  Reading reading;
  std::string table, statistics, plot;
  Output output;
};

/// Of --table; --statistics chooses columns of the summary.
MeasureRequest::Output table_of(const MeasureArguments& options) {
  using Table = MeasureRequest::Output;
  if (is_measure_output(options.output.file))
    throw Error(
        fmt::format("--output {}", options.output.file),
        "it names the file that is written, and --table the table",
        fmt::format("write --table {0}, or --output ./{0} for a file of that name", options.output.file));
  if (options.table.empty()) return options.statistics.empty() ? Table::orders : Table::summary;
  const Table table = parse_measure_output(options.table);
  if (!options.statistics.empty() && table != Table::summary)
    throw Error(fmt::format("--statistics with --table {}", options.table),
                "they are the columns of the summary, a row a tree",
                "take --table summary, or leave one out");
  return table;
}

MeasureRequest request_of(const MeasureArguments& options) {
  const MeasureRequest::Output output = table_of(options);
  MeasureRequest request = options.reading.request();
  request.output = output;
  if (!options.statistics.empty()) request.statistics = StatisticSet::parse(split_list(options.statistics));
  return request;
}

ExitCode measure(const MeasureArguments& options, const Cancellation& cancellation) {
  const auto warn = [](const std::string& warning) { fmt::print(stderr, "ramify: warning: {}\n", warning); };
  const MeasureRequest request = request_of(options);
  const auto picture = picture_file(options.plot);
  if (picture &&
      (request.output == MeasureRequest::Output::nodes || request.output == MeasureRequest::Output::levels))
    throw Error(fmt::format("--plot with --table {}", options.table), "a Horton diagram is of orders",
                "take orders or summary");
  const MeasuredFiles measured = measure_files(request, cancellation, warn);
  if (picture) picture->draw(horton_plot(measured.orders, request.leaf_order));
  std::visit([&](const auto& what) { emit(what, options.output); }, measured.content);
  return ExitCode::done;
}

}  // namespace

void add_measure(Program& program) {
  auto options = std::make_shared<MeasureArguments>();
  Verb verb = program.verb("measure", "Orders, ratios and every statistic of trees read from files");
  options->reading.add_to(verb);
  verb.option("--table", options->table,
              "orders (if nothing is said), summary (a row a tree), norms (beside Yule and uniform trees), "
              "levels (a row a depth), nodes (a row a node) or json");
  verb.option("--statistics,--statistic", options->statistics,
              "columns of the summary, comma-separated; see: ramify list statistics");
  options->output.add_table_to(verb);
  verb.option(
      "--plot", options->plot,
      "draw the Horton diagram, streams, lengths and radii by order, into this file, FILE.svg or FILE.png");
  verb.example("Example: ramify measure data/examples/sapling.newick");
  verb.work([options](const Cancellation& cancellation) { return measure(*options, cancellation); });
}

}  // namespace ramify::cli
