#include "ramify/model/parameter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

/// "1", "0.5", "1e9", "1/3": thirds are not to be read from their digits.
std::string end_text(double end) {
  if (const double power = std::log10(end);
      std::isfinite(power) && std::abs(power) >= 6 && power == std::round(power))
    return fmt::format("1e{}", power);
  const double thirds = end * 3;
  if (thirds == std::floor(thirds) && end != std::floor(end)) return fmt::format("{}/3", thirds);
  return fmt::format("{}", end);
}

std::string describe(const Parameter& of, std::string_view names) {
  const Domain& domain = of.domain;
  const std::string low = end_text(domain.low), high = end_text(domain.high);
  if (of.is_whole) return fmt::format("{} = {}, {}, ..., {}", names, low, domain.low + 1, high);
  if (std::isinf(domain.high)) return fmt::format("{} {} {}", names, domain.holds_low ? ">=" : ">", low);
  return fmt::format("{} {} {} {} {}", low, domain.holds_low ? "<=" : "<", names,
                     domain.holds_high ? "<=" : "<", high);
}

}  // namespace

bool Parameter::accepts(double value) const {
  return domain.contains(value) && (!is_whole || value == std::floor(value));
}

std::string Parameter::requirement() const {
  const std::string low = end_text(domain.low), high = end_text(domain.high);
  if (is_whole) return fmt::format("must be a whole number from {} to {}", low, high);
  if (std::isinf(domain.high))
    return fmt::format("must be a finite number {} {}", domain.holds_low ? "from" : "above", low);
  return fmt::format("must lie in {}{},{}{}{}", domain.holds_low ? '[' : '(', low, high,
                     domain.holds_high ? ']' : ')', reason);
}

void require_domain(std::string_view model, const Parameter& parameter, double value) {
  if (parameter.accepts(value)) return;
  throw Error(fmt::format("{} with {} = {}", model, parameter.name, value),
              fmt::format("{} {}", parameter.name, parameter.requirement()), std::string(parameter.remedy));
}

std::string describe_domains(std::span<const Parameter> parameters) {
  std::vector<std::pair<const Parameter*, std::string>> groups;
  for (const Parameter& parameter : parameters) {
    if (parameter.domain == Domain()) continue;
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      return group.first->domain == parameter.domain;
    });
    if (same == groups.end())
      groups.emplace_back(&parameter, parameter.name);
    else
      same->second.append(", ").append(parameter.name);
  }
  std::vector<std::string> texts;
  for (const auto& [parameter, names] : groups) texts.push_back(describe(*parameter, names));
  return fmt::format("{}", fmt::join(texts, ", "));
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
