#pragma once

namespace ramify {

/// What Ceres has to say is in its results; lines of its own on standard error are none of ours.
void quiet_ceres();

}  // namespace ramify
