#include "ramify/law/statistic_law.hpp"

#include <concepts>

#include "ramify/core/contract.hpp"

namespace ramify {

FiniteLaw FiniteLaw::mapped(AffineMap map) const {
  RAMIFY_EXPECTS(map.factor == 1);
  return {first + map.shift, probabilities};
}

StatisticLaw::StatisticLaw(const Recurrence& recurrence, Size largest_n)
    : computation_(computation(recurrence, largest_n)) {}

StatisticLaw::Computation StatisticLaw::computation(const Recurrence& recurrence, Size largest_n) {
  if (const auto* join = std::get_if<BoundedJoin>(&recurrence)) return BoundedLaw(*join, largest_n);
  if (const auto* walk = std::get_if<WeightedWalk>(&recurrence)) return DepthLaw(*walk);
  if (const auto* sum = std::get_if<NodeSum>(&recurrence)) return NodeSumLaw(*sum);
  RAMIFY_EXPECTS(std::holds_alternative<LongestPath>(recurrence));
  return HeightLaw();
}

Size StatisticLaw::sizes() const {
  return std::visit([](const auto& law) { return law.sizes(); }, computation_);
}

void StatisticLaw::extend(const SplitRow& row) {
  std::visit([&row](auto& law) { law.extend(row); }, computation_);
}

Moments StatisticLaw::moments(Size n) const {
  return std::visit([n](const auto& law) { return law.moments(n); }, computation_);
}

std::optional<FiniteLaw> StatisticLaw::law(Size n) const {
  return std::visit(
      [n]<class Law>(const Law& law) -> std::optional<FiniteLaw> {
        if constexpr (std::same_as<Law, NodeSumLaw>) {
          return std::nullopt;
        } else {
          return finite_law(law, n);
        }
      },
      computation_);
}

}  // namespace ramify
