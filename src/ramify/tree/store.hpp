#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "ramify/tree/grammar.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// Grows a tree and keeps it: the same tree as Grower folds from the same stream. 4 bytes a node plus
/// O(height).
/// @param look  called with the label of every node, in preorder
template <class G, class Urbg, class Look>
  requires Grammar<G, Urbg>
Tree grow_tree(const G& grammar, typename G::Label root, Urbg& stream, Look look) {
  std::vector<std::uint32_t> arity;
  std::vector<typename G::Label> pending{root};
  while (!pending.empty()) {
    const auto label = pending.back();
    pending.pop_back();
    look(label);
    if (grammar.is_external(label)) {
      arity.push_back(0);
      continue;
    }
    const auto children = grammar.children(label, stream);
    arity.push_back(2);
    pending.push_back(children[1]);
    pending.push_back(children[0]);
  }
  return Tree(std::move(arity));
}

template <class G, class Urbg>
Tree grow_tree(const G& grammar, typename G::Label root, Urbg& stream) {
  return grow_tree(grammar, root, stream, [](const auto&) {});
}

}  // namespace ramify
