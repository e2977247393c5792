#include <new>

#include "session.hpp"
#include "signals.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/memory.hpp"

namespace {

using ramify::cli::ExitCode;

int report(std::string_view message, int code) {
  ramify::cli::clear_progress_line();
  fmt::print(stderr, "ramify: {}\n", message);
  return code;
}

int refuse(std::string_view message) {
  return report(message, static_cast<int>(ExitCode::bad_input));
}

int run_program(int argc, char** argv) {
  static ramify::cli::Program program;  // a signal may come as late as the end of the process
  ramify::cli::listen_for_signals(program.cancellation());
  ramify::bound_memory();
  ramify::cli::add_verbs(program);
  return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const ramify::Interrupted&) {
    return report("interrupted", ramify::cli::interrupted_code());
  } catch (const ramify::cli::ClosedPipe&) {
    return static_cast<int>(ExitCode::closed_pipe);
  } catch (const ramify::Error& error) {
    return refuse(error.what());
  } catch (const std::bad_alloc&) {
    return refuse(
        fmt::format("out of memory (more than {}, which is all that this process may use): take a "
                    "smaller n, fewer replicates or fewer threads",
                    ramify::in_bytes(ramify::usable_memory())));
  } catch (const std::exception& error) {
    // The system's refusal (no more threads, a folder that vanished) or our fault: one line either way.
    return refuse(
        fmt::format("{} (this was not foreseen): please report it, with the command", error.what()));
  }
}
