#include <limits>
#include <memory>

#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/config/size_list.hpp"
#include "ramify/core/memory.hpp"
#include "ramify/tabulate/law_plot.hpp"
#include "ramify/tabulate/law_table.hpp"

namespace ramify::cli {
namespace {

struct LawArguments {
  std::string model, n, statistic, plot;
  Output output;
  bool moments = false, covariances = false, yes = false, exact = false;

  LawQuantity quantity() const {
    if (moments) return LawQuantity::moments;
    return covariances ? LawQuantity::covariances : LawQuantity::law;
  }
};

ExitCode law(const LawArguments& options, const Cancellation& cancellation) {
  const LawRequest request{Model::parse(options.model), LawSubject::parse(options.statistic),
                           options.quantity(), read_law_sizes("--n", options.n), options.exact};
  const double seconds = options.yes ? std::numeric_limits<double>::infinity() : long_law_seconds;
  require_computable(request, {usable_memory(), seconds});
  const auto picture = picture_file(options.plot);
  if (picture) require_drawable(request);
  const Table table = law_table(request, cancellation);
  if (picture) picture->draw(law_plot(request, table));
  emit(table, options.output);
  return ExitCode::done;
}

}  // namespace

void add_law(Program& program) {
  auto options = std::make_shared<LawArguments>();
  Verb verb = program.verb("law",
                           "Exact law of a statistic at finite n, computed without sampling: probabilities "
                           "right to 1e-15, of height and strahler to 12 digits from 1e-20 up");
  verb.option("--model", options->model, "model, such as bst or \"beta(10,80)\"; see: ramify list models",
              Need::required);
  verb.option("--n", options->n, "sizes to 1e300: N[,N..], or from:to:count, a geometric grid",
              Need::required);
  verb.option("--statistic,--statistics", options->statistic,
              fmt::format("{}: mean nodes and streams by order; with --moments also {}",
                          fmt::join(law_subjects(), ", "), fmt::join(moment_subjects(), ", ")),
              Need::required);
  const DeclaredOption moments = verb.flag(
      "--moments", options->moments, "mean and variance; of orders: of the nodes and streams of every order");
  Verb::exclude(moments, verb.flag("--covariances", options->covariances, "of orders: of every two counts"));
  verb.flag("--exact", options->exact,
            "by the recurrence over all sizes, however large; else on a grid of sizes where that takes more "
            "than a second");
  verb.flag("--yes", options->yes, "allow more than an hour");
  options->output.add_table_to(verb);
  verb.option("--plot", options->plot, "draw the law into this file, FILE.svg or FILE.png");
  verb.example("Example: ramify law --model \"patricia(1/4.35)\" --n 579 --statistic strahler");
  verb.work([options](const Cancellation& cancellation) { return law(*options, cancellation); });
}

}  // namespace ramify::cli
