#include <filesystem>
#include <memory>

#include "reading.hpp"
#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/dossier/report_page.hpp"
#include "ramify/fit/model_fits.hpp"
#include "ramify/page/html_writer.hpp"
#include "ramify/page/markdown_writer.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify::cli {
namespace {

struct ReportArguments {
  std::vector<std::string> files;
  std::string format = "auto", root, resolve, model, replicates = "999", bootstrap = "99", seed = "1996",
              threads;
  Output output;
};

enum class Form { html, md };

Form form_of(const ReportArguments& options) {
  if (options.format == "html") return Form::html;
  if (options.format == "md") return Form::md;
  if (options.format != "auto")
    throw Error(fmt::format("--format {}", options.format), "not a format that report writes",
                "take html, md, or auto");
  return std::filesystem::path(options.output.file).extension() == ".md" ? Form::md : Form::html;
}

/// HTML is not for a terminal to show: before any work.
void require_readable_output(const ReportArguments& options, Form form) {
  if (form == Form::html && options.output.is_for_reading())
    throw Error("a page of HTML on a terminal", "a browser shows it",
                "add -o report.html, or --format md to read it here");
}

ReportRequest request_of(const ReportArguments& options) {
  ReportRequest request{options.files, options.root, options.resolve, {}};
  if (!options.model.empty()) request.families = chosen_families(options.model, families());
  request.replicates = read_replicates(options.replicates);
  request.bootstrap = read_bootstrap(options.bootstrap);
  request.seed = read_count("--seed", options.seed);
  request.threads = read_threads(options.threads);
  request.progress = progress_line("report");
  return request;
}

void warn(const std::vector<std::string>& warnings) {
  for (const auto& line : warnings) {
    clear_progress_line();
    fmt::print(stderr, "ramify: warning: {}\n", line);
  }
}

ExitCode report(const ReportArguments& options, const Cancellation& cancellation) {
  const Form form = form_of(options);
  require_readable_output(options, form);
  const ReportRequest request = request_of(options);
  const std::vector<Subject> subjects = read_subjects(request);
  for (const Subject& subject : subjects) warn(subject.remarks);
  const Report made = report_page(subjects, request, cancellation);
  warn(made.warnings);
  emit(form == Form::html ? write_html(made.page) : write_markdown(made.page), options.output);
  return made.converged ? ExitCode::done : ExitCode::no_convergence;
}

}  // namespace

void add_report(Program& program) {
  auto options = std::make_shared<ReportArguments>();
  Verb verb = program.verb(
      "report", "One page about trees: picture, orders, ratios, which model they are like, in plain words");
  verb.option("FILE", options->files, "files of trees, or of counts of streams; - is standard input",
              Need::required);
  verb.option("--format", options->format, "html or md; auto: md where the output ends in .md, else html",
              Need::defaulted);
  verb.option("--root", options->root, "of a table with trees: the id of the root, all, or neurites");
  add_resolve(verb, options->resolve);
  verb.option("--model", options->model,
              "families to fit, NAME[,NAME..] or all; all if left out, but of counts those that are quick");
  verb.option("--replicates", options->replicates, "trees of the best model that a tree is compared with",
              Need::defaulted);
  verb.option("--bootstrap", options->bootstrap,
              "trees that say how well the best model fits a tree; 0 for none", Need::defaulted);
  verb.option("--seed", options->seed, "seed", Need::defaulted);
  add_threads(verb, options->threads);
  options->output.add_to(verb);
  verb.example("Example: ramify report data/examples/sapling.newick --format md");
  verb.work([options](const Cancellation& cancellation) { return report(*options, cancellation); });
}

}  // namespace ramify::cli
