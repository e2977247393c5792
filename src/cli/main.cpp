#include <csignal>
#include <new>

#include "session.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace {

using ramify::cli::ExitCode;

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

int report(const char* message, ExitCode code) {
  ramify::cli::clear_progress_line();
  fmt::print(stderr, "ramify: {}\n", message);
  return static_cast<int>(code);
}

int run_program(int argc, char** argv) {
  ramify::cli::Program program;
  listen_for_signals(program.cancellation());
  ramify::cli::add_verbs(program);
  return program.run(argc, argv);
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
