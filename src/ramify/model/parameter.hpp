#pragma once

#include <string_view>

namespace ramify {

/// Throws Error unless 0 < value < 1. model is the way it is written, "dst(p)".
void require_probability(std::string_view model, std::string_view name, double value);

/// Throws Error unless value is finite and positive.
void require_positive(std::string_view model, std::string_view name, double value);

}  // namespace ramify
