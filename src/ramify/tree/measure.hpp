#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "ramify/tree/fold.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

namespace detail {

/// Two children, which most nodes have, are handed over as in a growing tree: folds then need no memory.
template <class F>
typename F::Value join(F& fold, Size size, std::span<const Size> sizes,
                       std::span<const typename F::Value> values) {
  constexpr bool takes_pairs =
      requires { fold.join(size, Pair<Size>{}, Pair<typename F::Value>{values[0], values[1]}); };
  if constexpr (takes_pairs) {
    if (sizes.size() == 2)
      return fold.join(size, Pair<Size>{sizes[0], sizes[1]}, Pair<typename F::Value>{values[0], values[1]});
  }
  return fold.join(size, sizes, values);
}

}  // namespace detail

/// Folds a stored tree of any arity; labels are sizes (internal nodes of the subtree).
///
/// @param tree   at least one node
/// @param visit  called with every node's position and value, children before their parent
/// Reads the word backwards, which is a postorder with siblings last to first; a fold that draws at random
/// therefore takes other draws than a growing tree does, from the same law. O(nodes) time, O(height + arity)
/// memory.
template <class F, class Visit>
typename F::Value measure(const Tree& tree, F& fold, Visit visit) {
  RAMIFY_EXPECTS(tree.node_count() > 0);
  using Value = typename F::Value;
  std::vector<Size> sizes;
  std::vector<Value> values;
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    const std::size_t children = tree.arity(node);
    if (children == 0) {
      sizes.push_back(0);
      values.push_back(fold.external());
      visit(node, values.back());
      continue;
    }
    // The stack holds the leftmost child on top: turn the top run round to hand the children over left to
    // right.
    const auto first = static_cast<std::ptrdiff_t>(values.size() - children);
    std::reverse(sizes.begin() + first, sizes.end());
    std::reverse(values.begin() + first, values.end());
    const std::span<const Size> child_sizes(sizes.data() + first, children);
    const std::span<const Value> child_values(values.data() + first, children);
    const Size size = 1 + std::accumulate(child_sizes.begin(), child_sizes.end(), Size{0});
    const Value value = detail::join(fold, size, child_sizes, child_values);
    sizes.erase(sizes.begin() + first, sizes.end());
    values.erase(values.begin() + first, values.end());
    sizes.push_back(size);
    values.push_back(value);
    visit(node, value);
  }
  return values.back();
}

template <class F>
typename F::Value measure(const Tree& tree, F& fold) {
  return measure(tree, fold, [](std::size_t, const typename F::Value&) {});
}

}  // namespace ramify
