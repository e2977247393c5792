#include "ramify/model/parameter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

void require_probability(std::string_view model, std::string_view name, double value) {
  if (value > 0 && value < 1) return;
  throw Error(fmt::format("{} with {} = {}", model, name, value), fmt::format("{} must lie in (0,1)", name),
              "give a number strictly between 0 and 1, such as 0.23 or 1/4.35");
}

void require_above(std::string_view model, std::string_view name, double value, double bound,
                   std::string_view remedy) {
  if (value > bound && std::isfinite(value)) return;
  throw Error(fmt::format("{} with {} = {}", model, name, value),
              fmt::format("{} must be a finite number above {}", name, bound), std::string(remedy));
}

void require_positive(std::string_view model, std::string_view name, double value) {
  require_above(model, name, value, 0, "give a positive number, such as 10");
}

double require_distribution(std::string_view problem, std::span<const double> probabilities) {
  const double sum = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
  if (std::any_of(probabilities.begin(), probabilities.end(), [](double p) { return !(p >= 0); }))
    throw Error(problem, "a probability is not negative", "give numbers from 0 to 1");
  if (!(std::abs(sum - 1) <= 1e-9))
    throw Error(problem, fmt::format("the probabilities sum to {}, {} off 1", sum, sum - 1),
                "correct one of them");
  return sum;
}

}  // namespace ramify
