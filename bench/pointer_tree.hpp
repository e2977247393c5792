#pragma once

#include <vector>

#include "ramify/random/stream.hpp"
#include "ramify/tree/fold.hpp"

namespace ramify::bench {

/// A node of a tree as a first program would write it: the shape and nothing else.
struct PointerNode {
  PointerNode* left = nullptr;
  PointerNode* right = nullptr;
};

/// How a pointer tree holds its external nodes.
enum class External {
  allocated,  ///< nodes like any other: 2n+1 times `new`
  null,       ///< null pointers: n times `new`, the leanest tree of its kind
};

template <External external>
bool is_external(const PointerNode* node) {
  return external == External::null ? node == nullptr : node->left == nullptr;
}

/// Draws in preorder, so the tree is the one Grower folds from the same stream. An explicit stack: a Catalan
/// tree of 10^7 nodes is too high for recursion.
template <External external, class G>
PointerNode* build_pointer_tree(const G& grammar, Size root, Stream& stream) {
  struct Pending {
    Size size;
    PointerNode** place;
  };
  PointerNode* tree = nullptr;
  std::vector<Pending> pending;
  const auto push = [&](Size size, PointerNode** place) {
    if (!grammar.is_external(size))
      pending.push_back({size, place});
    else if (external == External::allocated)
      *place = new PointerNode;
  };
  push(root, &tree);
  while (!pending.empty()) {
    const auto [size, place] = pending.back();
    pending.pop_back();
    const Pair<Size> children = grammar.children(size, stream);
    auto* const node = new PointerNode;
    *place = node;
    push(children[1], &node->right);
    push(children[0], &node->left);
  }
  return tree;
}

/// The fold's value at the root, by an iterative postorder walk; for folds that do not look at labels, which
/// are not stored.
template <External external, class F>
typename F::Value fold_pointer_tree(const PointerNode* node, F& fold) {
  using Value = typename F::Value;
  struct Open {
    const PointerNode* node;
    Value left;
    bool left_done;
  };
  std::vector<Open> open;
  for (;;) {
    for (; !is_external<external>(node); node = node->left) open.push_back({node, Value(), false});
    Value value = fold.external();
    while (!open.empty() && open.back().left_done) {
      value = fold.join(Size{0}, Pair<Size>{}, Pair<Value>{open.back().left, value});
      open.pop_back();
    }
    if (open.empty()) return value;
    open.back().left = value;
    open.back().left_done = true;
    node = open.back().node->right;
  }
}

inline void delete_pointer_tree(PointerNode* tree) {
  std::vector<PointerNode*> pending;
  if (tree != nullptr) pending.push_back(tree);
  while (!pending.empty()) {
    PointerNode* const node = pending.back();
    pending.pop_back();
    if (node->right != nullptr) pending.push_back(node->right);
    if (node->left != nullptr) pending.push_back(node->left);
    delete node;
  }
}

}  // namespace ramify::bench
