#pragma once

#include "ramify/core/cancellation.hpp"

namespace ramify::cli {

/// From now on Ctrl-C and SIGTERM ask the work to stop. Work that has not stopped 1.5 s later ends with the
/// process (unfinished files are removed), and so it does at a second signal: whatever it is in the middle
/// of, two seconds are the most a user waits. A closed pipe is an error of writing, not a signal.
/// @param cancellation  of the work; must live as long as the process
void listen_for_signals(Cancellation& cancellation);

/// 128 + the signal that asked for the stop: 130 or 143.
int interrupted_code();

}  // namespace ramify::cli
