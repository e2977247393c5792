#include <new>
#include <string>
#include <utility>

#include "session.hpp"
#include "signals.hpp"
#include "verbs.hpp"
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/memory.hpp"
#include "ramify/ranks/joined_team.hpp"

namespace {

using ramify::cli::ExitCode;

/// How the command ended, and what is to be said of it.
struct Ending {
  int code;
  std::string message;
};

Ending refusal(std::string message) {
  return {static_cast<int>(ExitCode::bad_input), std::move(message)};
}

/// What `work` returns, or what it throws in a line.
template <class Work>
Ending ending_of(Work work) {
  try {
    return {work(), {}};
  } catch (const ramify::Dismissed&) {
    return {0, {}};  // the leading process says why
  } catch (const ramify::Interrupted&) {
    return {ramify::cli::interrupted_code(), "interrupted"};
  } catch (const ramify::cli::ClosedPipe&) {
    return {static_cast<int>(ExitCode::closed_pipe), {}};
  } catch (const ramify::Error& error) {
    return refusal(error.what());
  } catch (const std::bad_alloc&) {
    return refusal(
        fmt::format("out of memory (more than {}, which is all that this process may use): take a "
                    "smaller n, fewer replicates or fewer threads",
                    ramify::in_bytes(ramify::usable_memory())));
  } catch (const std::exception& error) {
    // The system's refusal (no more threads, a folder that vanished) or our fault: one line either way.
    return refusal(
        fmt::format("{} (this was not foreseen): please report it, with the command", error.what()));
  }
}

void say(const Ending& ending) {
  ramify::cli::clear_progress_line();
  if (!ending.message.empty()) fmt::print(stderr, "ramify: {}\n", ending.message);
}

/// The command as one process of a team, which is left whatever happens.
int run_in_team(ramify::cli::Program& program, ramify::JoinedTeam& team, int argc, char** argv) {
  ramify::cli::forget_terminal();
  ramify::share_memory(team.neighbours());
  ramify::bound_memory();
  const Ending ending = ending_of([&] { return program.run(argc, argv, &team); });
  say(ending);
  team.leave(ending.message);
  return team.leads() ? ending.code : 0;
}

int run_program(int argc, char** argv) {
  static ramify::cli::Program program;  // a signal may come as late as the end of the process
  ramify::cli::listen_for_signals(program.cancellation());
  ramify::cli::add_verbs(program);
  if (const auto team = ramify::join_team(program.cancellation()))
    return run_in_team(program, *team, argc, argv);
  ramify::bound_memory();
  return program.run(argc, argv, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  const Ending ending = ending_of([&] { return run_program(argc, argv); });
  say(ending);
  return ending.code;
}
