#pragma once

namespace ramify::cli {

/// Exit codes of the command line.
enum class ExitCode : int {
  done = 0,
  check_failed = 1,  ///< a verdict changed, or a sampler disagrees with its law
  bad_input = 2,
  no_convergence = 3,  ///< of a fit
  interrupted = 130
};

}  // namespace ramify::cli
