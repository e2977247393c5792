#include "ramify/fit/nested_test.hpp"

#include <algorithm>
#include <cmath>

namespace ramify {
namespace {

constexpr double of_rounding =
    1e-6;  // of a likelihood ratio: less is a tie, as at an end of the larger family

}  // namespace

std::vector<NestedPair> nested_pairs(std::vector<FamilyFit>& fits) {
  std::vector<NestedPair> pairs;
  for (FamilyFit& larger : fits) {
    if (!larger.converged || std::isnan(larger.log_likelihood)) continue;
    for (const NestedFamily& nested : larger.family->nested)
      for (const FamilyFit& simpler : fits)
        if (simpler.family->name == nested.name && !std::isnan(simpler.log_likelihood))
          pairs.push_back({&simpler, &larger, larger.family->searched(nested.values)});
  }
  return pairs;
}

double likelihood_ratio(const NestedPair& pair) {
  return std::max(0.0, 2 * (pair.larger->log_likelihood - pair.simpler->log_likelihood));
}

double likelihood_ratio(const Family& larger, const Objective& minus_log_likelihood, const Point& place) {
  const double simpler = minus_log_likelihood.value(place);
  const Point best = best_place(larger, minus_log_likelihood, place);
  return std::max(0.0, 2 * (simpler - minus_log_likelihood.value(best)));
}

void add_nested_test(const NestedPair& pair, std::span<const double> grown) {
  const double observed = likelihood_ratio(pair);
  const auto as_far =
      std::ranges::count_if(grown, [observed](double ratio) { return ratio >= observed - of_rounding; });
  const double trees = static_cast<double>(grown.size());
  pair.larger->simpler.push_back(
      {pair.simpler->family, observed, (1 + static_cast<double>(as_far)) / (1 + trees), grown.size()});
}

}  // namespace ramify
