#include "ramify/config/replicate_rule.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

std::uint64_t ReplicateRule::count(Size n) const {
  const auto covers = [n](const auto& bound) { return n <= bound.first; };
  const auto bound = std::find_if(up_to.begin(), up_to.end(), covers);
  if (bound != up_to.end()) return bound->second;
  if (above) return *above;
  throw Error(fmt::format("no number of replicates for n = {}", n), "it is above every bound of replicates",
              "add above = 100 to replicates, or a larger bound");
}

}  // namespace ramify
