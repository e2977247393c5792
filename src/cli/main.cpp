#include <csignal>
#include <new>

#include "session.hpp"
#include <fmt/format.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/core/version.hpp"

namespace {

using ramify::ExitCode;

ramify::Cancellation* stop_flag = nullptr;

extern "C" void on_signal(int) {
  stop_flag->request();
}

void listen_for_signals(ramify::Cancellation& cancellation) {
  stop_flag = &cancellation;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGPIPE, SIG_IGN);
}

/// One line for anything the command line got wrong.
int refuse_arguments(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
  std::vector<std::string> verbs;
  for (const auto* verb : app.get_subcommands({})) verbs.push_back(verb->get_name());
  const std::string given = argc > 1 ? argv[1] : "";
  const bool known = std::find(verbs.begin(), verbs.end(), given) != verbs.end();
  if (!given.empty() && given[0] != '-' && !known) {
    fmt::print(stderr, "ramify: unknown verb '{}' (there is no such verb): {}see: ramify --help\n", given,
               ramify::did_you_mean(given, verbs));
  } else {
    fmt::print(stderr, "ramify: {} (the command line was not understood): see: ramify {}--help\n",
               error.what(), known ? given + " " : "");
  }
  return static_cast<int>(ExitCode::bad_input);
}

int report(const char* message, ExitCode code) {
  ramify::cli::clear_progress_line();
  fmt::print(stderr, "ramify: {}\n", message);
  return static_cast<int>(code);
}

int run_program(int argc, char** argv) {
  namespace cli = ramify::cli;
  CLI::App app("ramify: a statistical laboratory for random branching structures", "ramify");
  app.set_version_flag("--version", std::string("ramify ") + ramify::version);
  app.require_subcommand(1);
  app.footer(
      "Example: ramify sample --model bst --n 1000 --replicates 5\nramify VERB --help shows one for every "
      "verb.");
  cli::Session session;
  listen_for_signals(session.cancellation);
  cli::add_list(app, session);
  cli::add_sample(app, session);
  cli::add_law(app, session);
  cli::add_measure(app, session);
  cli::add_test(app, session);
  cli::add_trie(app, session);
  cli::add_theory(app, session);
  cli::add_run(app, session);
  cli::add_reproduce(app, session);
  cli::add_fit(app, session);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return refuse_arguments(app, error, argc, argv);
  }
  return static_cast<int>(session.work());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const ramify::Interrupted&) {
    return report("interrupted", ExitCode::interrupted);
  } catch (const ramify::Error& error) {
    return report(error.what(), ExitCode::bad_input);
  } catch (const std::bad_alloc&) {
    return report(
        "out of memory (the tree is deeper, or the table larger, than this machine holds): take a smaller n",
        ExitCode::bad_input);
  }
}
