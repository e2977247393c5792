#include "program.hpp"

#include <algorithm>

#include "program_pages.hpp"
#include "session.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/core/version.hpp"

namespace ramify::cli {
namespace {

DeclaredOption declared(CLI::Option* option, Need need) {
  // An empty value is most often a variable of a script that is not set, never meant as "left out".
  option->check([](const std::string& value) { return std::string(value.empty() ? "is empty" : ""); }, "");
  if (need == Need::defaulted) option->capture_default_str();
  if (need == Need::required) option->required();
  return {option};
}

}  // namespace

DeclaredOption Verb::option(const std::string& names, std::string& value, const std::string& what,
                            Need need) {
  return declared(app_->add_option(names, value, what), need);
}

DeclaredOption Verb::option(const std::string& names, std::vector<std::string>& values,
                            const std::string& what, Need need) {
  return declared(app_->add_option(names, values, what), need);
}

DeclaredOption Verb::flag(const std::string& names, bool& value, const std::string& what) {
  return {app_->add_flag(names, value, what)};
}

void Verb::exclude(DeclaredOption one, DeclaredOption other) {
  one.option->excludes(other.option);
}

void Verb::example(const std::string& text) {
  app_->footer(text);
}

void Verb::work(Work work) {
  app_->callback([chosen = chosen_, work = std::move(work)] { *chosen = {work, {}}; });
}

void Verb::team_work(TeamWork work) {
  app_->callback([chosen = chosen_, work = std::move(work)] { *chosen = {{}, work}; });
}

Program::Program()
    : app_(std::make_unique<CLI::App>("ramify: a statistical laboratory for random branching structures",
                                      "ramify")) {
  app_->set_version_flag("-V,--version", std::string("ramify ") + version);
  app_->require_subcommand(1);
  app_->footer(
      "Example: ramify sample --model bst --n 1000 --replicates 5\nramify VERB --help shows one for every "
      "verb.");
}

Program::~Program() = default;

Verb Program::verb(const std::string& name, const std::string& description) {
  return {*app_->add_subcommand(name, description), chosen_};
}

ProgramPages Program::pages() const {
  return ProgramPages(*app_);
}

/// One line for anything the command line got wrong.
int Program::refuse(const std::exception& error, const std::string& given) const {
  std::vector<std::string> verbs;
  for (const auto* verb : app_->get_subcommands({})) verbs.push_back(verb->get_name());
  const bool known = std::find(verbs.begin(), verbs.end(), given) != verbs.end();
  if (!given.empty() && given[0] != '-' && !known) {
    fmt::print(stderr, "ramify: unknown verb '{}' (there is no such verb): {}see: ramify --help\n", given,
               did_you_mean(given, verbs));
  } else {
    fmt::print(stderr, "ramify: {} (the command line was not understood): see: ramify {}--help\n",
               error.what(), known ? given + " " : "");
  }
  return static_cast<int>(ExitCode::bad_input);
}

ExitCode Program::work(const std::string& verb, Team* team) const {
  if (chosen_.together) return chosen_.together(team, cancellation_);
  if (team == nullptr) return chosen_.alone(cancellation_);
  if (!team->leads()) return ExitCode::done;
  say_alone(verb, *team);
  return chosen_.alone(cancellation_);
}

int Program::run(int argc, const char* const* argv, Team* team) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app_->exit(error);  // --help, --version
    return refuse(error, argc > 1 ? argv[1] : "");
  }
  const std::string verb = app_->get_subcommands().front()->get_name();
  show_progress(verb);
  const ExitCode code = work(verb, team);
  clear_progress_line();
  return static_cast<int>(code);
}

}  // namespace ramify::cli
