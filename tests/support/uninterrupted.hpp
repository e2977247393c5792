#pragma once

#include "ramify/core/cancellation.hpp"

namespace ramify::test {

/// Of work that nobody stops.
inline const Cancellation uninterrupted;

}  // namespace ramify::test
