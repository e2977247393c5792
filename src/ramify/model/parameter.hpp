#pragma once

#include <span>
#include <string_view>

namespace ramify {

/// Throws Error unless 0 < value < 1. model is the way it is written, "dst(p)".
void require_probability(std::string_view model, std::string_view name, double value);

/// Throws Error unless value is finite and above bound; remedy says what to give instead.
void require_above(std::string_view model, std::string_view name, double value, double bound,
                   std::string_view remedy);

/// Throws Error unless value is finite and positive.
void require_positive(std::string_view model, std::string_view name, double value);

/// The sum of the probabilities. Throws Error, beginning with `problem`, unless they are >= 0 and sum to 1
/// within 1e-9.
double require_distribution(std::string_view problem, std::span<const double> probabilities);

}  // namespace ramify
