#include "ramify/model/model_info.hpp"

#include <bit>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

/// "50", "2^50".
std::string size_text(Size n) {
  return std::has_single_bit(n) ? fmt::format("2^{}", std::countr_zero(n)) : fmt::format("{}", n);
}

}  // namespace

std::string ModelInfo::signature() const {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  return names.empty() ? std::string(name) : fmt::format("{}({})", name, fmt::join(names, ","));
}

std::string ModelInfo::domain() const {
  std::vector<std::string> parts;
  if (!given.empty()) parts.emplace_back(given);
  if (const auto numbers = describe_domains(parameters); !numbers.empty())
    parts.push_back(fmt::format("{}{}", numbers, together));
  if (largest_n < max_size) parts.push_back(fmt::format("n <= {}", size_text(largest_n)));
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, "; "));
}

void require_domain(const ModelInfo& info, std::span<const double> values) {
  RAMIFY_EXPECTS(values.size() == info.parameters.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!info.parameters[i].accepts(values[i]))
      require_domain(info.signature(), info.parameters[i], values[i]);
}

}  // namespace ramify
