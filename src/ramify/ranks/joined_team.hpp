#pragma once

#include <memory>
#include <string_view>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/workforce.hpp"

namespace ramify {

/// The leading process has ended the job: the others leave what they do.
class Dismissed {};

/// A team that is left in the end, by each of its processes, whatever happened in it.
class JoinedTeam : public Team {
 public:
  /// Processes of the team on this machine.
  virtual unsigned neighbours() const = 0;

  /// The last call: dismisses the others where this process leads, waits to be dismissed where it does not.
  /// @param failure  why it cannot go on, for the leading process to say; empty where all is well
  virtual void leave(std::string_view failure) = 0;
};

/// The team of this process: the ranks of an MPI job, of which rank 0 leads. None where it was started alone.
///
/// In the others standard output and error lead nowhere from here on: one process has the terminal.
/// Throws Error where it was started with others by a build without MPI: all of them would do all of the
/// work.
/// @param cancellation  requested when the process is dismissed while it works
std::unique_ptr<JoinedTeam> join_team(Cancellation& cancellation);

}  // namespace ramify
