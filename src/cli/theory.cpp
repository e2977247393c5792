#include "session.hpp"
#include "verbs.hpp"

#include "ramify/theory/constants.hpp"

namespace ramify::cli {
namespace {

Table constant_table(const std::vector<std::string>& model_texts, const Cancellation& cancellation) {
  Table table({"model", "constant", "value", "error", "formula", "source"});
  for (const auto& text : model_texts) {
    if (cancellation.requested()) throw Interrupted();
    const Model model = Model::parse(text);
    for (const auto& constant : constants(model))
      table.add(Row()
                    .texts({model.text(), constant.name})
                    .exact(constant.value)
                    .summary(constant.error)
                    .texts({constant.formula, constant.source}));
  }
  return table;
}

}  // namespace

void add_theory(Program& program) {
  struct Options {
    std::string models;
    Output output;
  };
  auto options = std::make_shared<Options>();
  Verb verb = program.verb("theory", "Limit constants of a model, computed, with formula, error and source");
  verb.option("--model,--models", options->models,
              "a model, or several separated by commas: \"bst,beta(10,80)\"", Need::required);
  options->output.add_table_to(verb);
  verb.example("Example: ramify theory --model \"beta(10,80)\"");
  verb.work([options](const Cancellation& cancellation) {
    emit(constant_table(split_list(options->models), cancellation), options->output);
    return ExitCode::done;
  });
}

}  // namespace ramify::cli
