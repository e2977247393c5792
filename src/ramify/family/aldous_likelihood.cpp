#include "ramify/family/aldous_likelihood.hpp"

#include <numbers>

#include "ramify/family/split_sizes.hpp"

namespace ramify {

AldousLikelihood::AldousLikelihood(const ObservedSplits& observed) {
  const SplitSizes all(observed);
  std::array<double, 4> harmonic{};
  Size reached = 1;
  for (std::size_t i = 0; i < all.sizes.size(); ++i) {
    while (reached < all.sizes[i]) {
      const double inverse = 1 / static_cast<double>(++reached);
      double power = 1;
      for (double& sum : harmonic) sum += power *= inverse;
    }
    sizes_.push_back({all.sizes[i], all.children[i], all.nodes[i], harmonic});
    constant_ += all.nodes[i] * std::log(2 / (static_cast<double>(all.sizes[i]) + 1));
  }
  for (const ObservedSplit& split : observed.splits())
    if (!split.is_even()) constant_ -= split.count * std::numbers::ln2;
}

}  // namespace ramify
