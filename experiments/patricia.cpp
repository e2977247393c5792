#include "patricia.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/theory/depth_constant.hpp"

namespace ramify {

std::vector<GrowthCase> patricia_cases(const StatisticInfo& statistic, double largest_even) {
  using Rungs = GrowthLadder::Rungs;
  using Approach = GrowthLadder::Approach;
  std::vector<GrowthCase> cases{
      {Model::parse("patricia(1/2)"), {&statistic, Rungs::medians, Approach::drifts, largest_even}}};
  constexpr double largest = 1e60;
  for (const char* model : {"patricia(1/2.74)", "patricia(0.23)", "patricia(1/4.8)"})
    cases.push_back({Model::parse(model), {&statistic, Rungs::medians, Approach::drifts, largest}});
  return cases;
}

std::function<Basis(const Evidence&)> above_fair_fill_level(std::string_view letter, double largest_even) {
  const GrowthCase fill_level = patricia_cases(statistic::fill_level, largest_even).front();
  return [letter = std::string(letter), below = growth_basis(fill_level)](const Evidence& evidence) {
    Basis basis = below(evidence);
    basis.interval.upper = 1 / std::log(2.0);
    basis.estimate = std::min(basis.estimate, basis.interval.upper);
    basis.method =
        fmt::format("{0}_n <= log2(n+1) in every tree; from below F_n <= {0}_n, {1}", letter, basis.method);
    return basis;
  };
}

std::vector<NamedValue> rival_patricia_orders(const Model& model) {
  const double p = model.parameters().front();
  const double inverse_entropy = depth_constant(model).value().value;
  return {{"1/log(h/(pq)), the first ratio of streams", -1 / std::log(p * (1 - p) * inverse_entropy)},
          {"1/h, the depth", inverse_entropy}};
}

}  // namespace ramify
