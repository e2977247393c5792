#include "ramify/model/parameter.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

void require_probability(std::string_view model, std::string_view name, double value) {
  if (value > 0 && value < 1) return;
  throw Error(fmt::format("{} with {} = {}", model, name, value), fmt::format("{} must lie in (0,1)", name),
              "give a number strictly between 0 and 1, such as 0.23 or 1/4.35");
}

void require_positive(std::string_view model, std::string_view name, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw Error(fmt::format("{} with {} = {}", model, name, value),
              fmt::format("{} must be a finite number above 0", name), "give a positive number, such as 10");
}

}  // namespace ramify
