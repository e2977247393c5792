#include "ramify/fit/bootstrap.hpp"

#include <cmath>

#include "ramify/accumulate/real_summary.hpp"

namespace ramify {

void summarise_bootstrap(const std::vector<std::vector<double>>& estimates, FamilyFit& fit) {
  fit.bootstrap.clear();
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    RealSummary summary;
    for (const auto& tree : estimates) summary.add(tree[i]);
    const auto band = summary.interpolated_quantiles({0.025, 0.975});
    fit.bootstrap.push_back(
        {band[0], band[1], summary.mean() - fit.parameters[i].estimate, std::sqrt(summary.variance())});
  }
}

}  // namespace ramify
