#pragma once

namespace ramify::cli {

/// Exit codes of the command line.
enum class ExitCode : int {
  done = 0,
  check_failed = 1,  ///< a verdict changed, or a sampler disagrees with its law
  bad_input = 2,
  no_convergence = 3,  ///< of a fit
  closed_pipe = 141,   ///< whoever read the output has gone; interrupted are 130 and 143 (signals.hpp)
};

}  // namespace ramify::cli
