#pragma once

#include <vector>

#include "ramify/tree/grammar.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// Grows a tree and keeps it: the same tree as Grower folds from the same stream. 4 bytes a node plus
/// O(height).
template <class G, class Urbg>
  requires Grammar<G, Urbg>
Tree grow_tree(const G& grammar, typename G::Label root, Urbg& stream) {
  std::vector<std::uint32_t> arity;
  std::vector<typename G::Label> pending{root};
  while (!pending.empty()) {
    const auto label = pending.back();
    pending.pop_back();
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

}  // namespace ramify
