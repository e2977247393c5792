#pragma once

#include <concepts>
#include <cstdint>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/tree/fold.hpp"
#include "ramify/tree/graft.hpp"
#include "ramify/tree/grammar.hpp"
#include "ramify/tree/segmented_stack.hpp"

namespace ramify {

/// An open node of a growing tree: its label, the label of the child that is not being grown, and, once the
/// left child is done, that child's value.
template <class Label, class Value>
class OpenNode {
 public:
  OpenNode() = default;
  OpenNode(const Label& label, const Label& right) : label_(label), sibling_(right), left_done_(false) {}

  bool left_done() const { return left_done_; }
  const Label& label() const { return label_; }
  const Label& sibling() const { return sibling_; }
  const Value& left_value() const { return left_value_; }

  /// The left child is done: from now on the right one is grown.
  void finish_left(const Label& left, const Value& value) {
    sibling_ = left;
    left_value_ = value;
    left_done_ = true;
  }

 private:
  Label label_;
  Label sibling_;
  Value left_value_;
  bool left_done_;
};

/// Sizes stay below 2^62, so the top bit of the sibling's size says whether the left child is done: with a
/// value of 8 bytes an open node costs 24 bytes instead of 32.
template <class Value>
class OpenNode<Size, Value> {
 public:
  OpenNode() = default;
  OpenNode(Size label, Size right) : label_(label), tagged_sibling_(right) {}

  bool left_done() const { return (tagged_sibling_ & done_bit) != 0; }
  Size label() const { return label_; }
  Size sibling() const { return tagged_sibling_ & ~done_bit; }
  const Value& left_value() const { return left_value_; }

  void finish_left(Size left, const Value& value) {
    tagged_sibling_ = left | done_bit;
    left_value_ = value;
  }

 private:
  static constexpr Size done_bit = Size{1} << 63;
  Size label_;
  Size tagged_sibling_;
  Value left_value_;
};

/// Grows a tree depth-first, left before right, and folds it on the way: the tree is never stored. What the
/// graft policy covers is not grown either: its value is drawn (graft.hpp).
///
/// Draws from the stream in preorder, so without grafts the tree is the one grow_tree stores (store.hpp).
/// Memory: one OpenNode for every level, on an explicit stack that is kept between trees; use one Grower for
/// each thread.
///
/// What is done at every node (close, the push of the stack, the join of several folds) is inlined by name:
/// the compiler's own budget is one for all loops of a source, and a model more took a fifth of everybody's
/// speed.
template <class G, class F, class Urbg>
  requires Grammar<G, Urbg> && Fold<F, typename G::Label>
class Grower {
 public:
  using Label = typename G::Label;
  using Value = typename F::Value;

  /// @param cancellation  looked at every 2^20 leaves; must outlive the Grower
  explicit Grower(const Cancellation& cancellation) : cancellation_(&cancellation) {}

  /// The fold's value at the root; O(nodes grown) time. Throws Interrupted when cancelled.
  template <class Graft = NoGraft>
  Value operator()(const G& grammar, Label label, Urbg& stream, F& fold, const Graft& graft = {}) {
    const Growth<Graft> growth{grammar, stream, fold, graft};
    open_.clear();
    if (growth.is_done(label)) return growth.value(label);
    for (;;) {
      Value value = descend(growth, label);
      for (;;) {
        while (!open_.empty() && open_.top().left_done()) value = close(label, value, fold);
        if (open_.empty()) return value;
        const Label right = open_.top().sibling();
        open_.top().finish_left(label, value);
        label = right;
        if (!growth.is_done(right)) break;
        value = close(label, growth.value(right), fold);  // such a right child closes its parent at once
      }
      look_for_cancellation();
    }
  }

  /// Memory of the deepest tree so far, in bytes.
  std::size_t stack_bytes() const { return open_.capacity_bytes(); }

 private:
  /// What one tree is grown from.
  template <class Graft>
  struct Growth {
    const G& grammar;
    Urbg& stream;
    F& fold;
    const Graft& graft;

    /// No node below this label is grown.
    bool is_done(const Label& label) const { return grammar.is_external(label) || graft.covers(label); }
    Value value(const Label& label) const {
      return grammar.is_external(label) ? fold.external() : graft.draw(label, stream, fold);
    }
  };

  /// From a node that is grown down to the left until a subtree is done: opens every node on the way, leaves
  /// the finished subtree in label.
  template <class Graft>
  Value descend(const Growth<Graft>& growth, Label& label) {
    for (;;) {
      const Pair<Label> children = growth.grammar.children(label, growth.stream);
      if (!growth.is_done(children[0])) {
        open_.push({label, children[1]});
        label = children[0];
        continue;
      }
      const Value left = growth.value(children[0]);
      if (growth.is_done(children[1]))
        return growth.fold.join(label, children, Pair<Value>{left, growth.value(children[1])});
      open_.push({label, children[1]});
      open_.top().finish_left(children[0], left);
      label = children[1];
    }
  }

  /// Both children of the last open node are done: joins them.
  [[gnu::always_inline]] Value close(Label& label, const Value& right, F& fold) {
    const auto& node = open_.top();
    const Label parent = node.label();
    const Value value =
        fold.join(parent, Pair<Label>{node.sibling(), label}, Pair<Value>{node.left_value(), right});
    label = parent;
    open_.pop();
    return value;
  }

  void look_for_cancellation() {
    if (--until_look_ != 0) return;
    until_look_ = leaves_between_looks;
    if (cancellation_->requested()) throw Interrupted();
  }

  static constexpr std::uint32_t leaves_between_looks = 1u << 20;
  SegmentedStack<OpenNode<Label, Value>> open_;
  const Cancellation* cancellation_;
  std::uint32_t until_look_ = leaves_between_looks;
};

}  // namespace ramify
