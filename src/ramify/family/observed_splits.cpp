#include "ramify/family/observed_splits.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "ramify/family/require_binary.hpp"

namespace ramify {

ObservedSplits::ObservedSplits(const Tree& tree, std::string_view where) {
  std::vector<Size> sizes;  // of subtrees that wait for their parent: the word is read backwards
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    if (tree.arity(node) == 0) {
      sizes.push_back(0);
      continue;
    }
    require_binary(tree.arity(node), where);
    const Size one = sizes.back();
    sizes.pop_back();
    const Size other = sizes.back();
    sizes.back() = one + other + 1;
    if (sizes.back() >= smallest_size) splits_.push_back({std::min(one, other), std::max(one, other), 1});
  }
  tree_sizes_.push_back(sizes.empty() ? 0 : sizes.back());
  merge_equal();
}

void ObservedSplits::add(const ObservedSplits& others) {
  splits_.insert(splits_.end(), others.splits_.begin(), others.splits_.end());
  tree_sizes_.insert(tree_sizes_.end(), others.tree_sizes_.begin(), others.tree_sizes_.end());
  merge_equal();
}

void ObservedSplits::merge_equal() {
  const auto key = [](const ObservedSplit& split) { return std::tuple(split.size(), split.smaller); };
  std::ranges::sort(splits_, {}, key);
  std::size_t kept = 0;
  for (const ObservedSplit& split : splits_) {
    if (kept > 0 && key(splits_[kept - 1]) == key(split))
      splits_[kept - 1].count += split.count;
    else
      splits_[kept++] = split;
  }
  splits_.resize(kept);
}

double ObservedSplits::nodes() const {
  return std::accumulate(tree_sizes_.begin(), tree_sizes_.end(), 0.0);
}

double ObservedSplits::choices() const {
  return std::accumulate(splits_.begin(), splits_.end(), 0.0,
                         [](double sum, const ObservedSplit& split) { return sum + split.count; });
}

}  // namespace ramify
