#include "ramify/family/split_sizes.hpp"

#include <algorithm>

namespace ramify {

SplitSizes::SplitSizes(const ObservedSplits& observed) {
  for (const ObservedSplit& split : observed.splits())
    sizes.insert(sizes.end(), {split.smaller, split.larger, split.size()});
  std::ranges::sort(sizes);
  const auto repeated = std::ranges::unique(sizes);
  sizes.erase(repeated.begin(), repeated.end());
  children.resize(sizes.size());
  nodes.resize(sizes.size());
  const auto place = [this](Size size) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(sizes, size) - sizes.begin());
  };
  for (const ObservedSplit& split : observed.splits()) {
    places.push_back({place(split.smaller), place(split.larger), place(split.size())});
    children[places.back().smaller] += split.count;
    children[places.back().larger] += split.count;
    nodes[places.back().node] += split.count;
  }
}

}  // namespace ramify
