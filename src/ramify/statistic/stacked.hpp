#pragma once

#include <new>
#include <type_traits>
#include <vector>

#include "ramify/statistic/joint.hpp"

namespace ramify {

/// A joint fold of a growing binary tree that keeps its values on a stack of its own, where a join reads and
/// writes them in place.
///
/// For many folds at once. A pack of 50 bytes that is handed up from node to node is copied in wide words
/// right after it was written in narrow ones, which a processor must wait for; that costs more than all joins
/// together (bench/full_pass_bench.cpp). Relies on nodes being joined in postorder, left before right.
template <class J>
class Stacked {
 public:
  struct Value {};
  using Folds = J;
  using Pack = typename J::Value;

  explicit Stacked(J fold) : fold_(std::move(fold)) {}

  Value external() {
    stack_.push_back(fold_.external());
    return {};
  }

  template <class Label>
  Value join(const Label& label, const Pair<Label>& labels, const Pair<Value>&) {
    Pack* left = stack_.data() + stack_.size() - 2;
    new (left) Pack(fold_.join(label, labels, TwoValues<Pack>{left}));
    stack_.pop_back();
    return {};
  }

  const J& fold() const { return fold_; }
  /// Of the root, once the tree is grown.
  const Pack& root() const { return stack_.back(); }

 private:
  static_assert(std::is_trivially_copyable_v<Pack>);

  J fold_;
  std::vector<Pack> stack_;
};

}  // namespace ramify
