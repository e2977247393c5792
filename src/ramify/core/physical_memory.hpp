#pragma once

namespace ramify {

/// Main memory of this machine, in bytes.
double physical_memory();

}  // namespace ramify
