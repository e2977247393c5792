#pragma once

#include <span>

namespace ramify {

/// The sum of the values, right to a rounding or two however many there are (Neumaier 1974), and the same on
/// every machine.
double compensated_sum(std::span<const double> values);

}  // namespace ramify
