#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// A model whose trees are not split trees: nodes of any number of children, labels that are no sizes. Its
/// trees are grown whole, stored and then measured; they have no exact laws here and nothing is grafted.
class GrownModel {
 public:
  virtual ~GrownModel() = default;

  /// The tree of parameter n, nodes drawn in preorder. 4 bytes a node. Throws Interrupted when cancelled.
  /// @param labels  if wanted: what label_meaning() says, of every node by its preorder place; 8 bytes a node
  virtual Tree grow(Size n, Stream& stream, const Cancellation& cancellation,
                    std::vector<std::uint64_t>* labels = nullptr) const = 0;

  /// "strings below"; "" of a model whose nodes carry none.
  virtual std::string_view label_meaning() const { return ""; }

  /// Mean number of nodes, internal and external; an estimate.
  virtual double expected_nodes(Size n) const = 0;

  /// The largest Horton-Strahler order, leaf order 0, of its trees.
  virtual std::size_t largest_order(Size n) const = 0;

  /// The largest n that it is defined for.
  virtual Size largest_size() const { return max_size; }

  /// Throws Error where there is no tree of parameter n <= largest_size().
  virtual void require_size(Size) const {}

  /// Of the content of a file; 0 where the parameters say all.
  virtual std::uint64_t content_hash() const { return 0; }
};

/// A grammar of nodes of any number of children as a model.
///
/// Requirements on a grammar g:
///   g.root(n)                    the root's label, of type G::Label
///   g.children(l, s, labels)     appends the labels of the children of a node, drawn from the stream s; none
///                                of an external one. It may change g: a tree is grown by a copy
///   G::label_meaning             what the label says, as a number: it is one, or has a size
///   g.expected_nodes(n), g.largest_order(n)                       as of GrownModel, and so
///   g.largest_size(), g.content_hash(), g.require_size(n)         where they are not the default
template <class G>
class GrammarModel final : public GrownModel {
 public:
  explicit GrammarModel(G grammar) : grammar_(std::move(grammar)) {}

  Tree grow(Size n, Stream& stream, const Cancellation& cancellation,
            std::vector<std::uint64_t>* labels) const override {
    constexpr std::size_t nodes_between_looks = std::size_t{1} << 20;
    std::unique_ptr<G> grammar = take();
    std::vector<std::uint32_t> arity;
    std::vector<typename G::Label> pending{grammar->root(n)}, children;
    while (!pending.empty()) {
      if (arity.size() % nodes_between_looks == 0 && cancellation.requested()) throw Interrupted();
      const auto label = pending.back();
      pending.pop_back();
      children.clear();
      grammar->children(label, stream, children);
      arity.push_back(static_cast<std::uint32_t>(children.size()));
      if (labels != nullptr) labels->push_back(number_of(label));
      pending.insert(pending.end(), children.rbegin(), children.rend());
    }
    give_back(std::move(grammar));
    return Tree(std::move(arity));
  }

  std::string_view label_meaning() const override { return G::label_meaning; }
  double expected_nodes(Size n) const override { return grammar_.expected_nodes(n); }
  std::size_t largest_order(Size n) const override { return grammar_.largest_order(n); }
  Size largest_size() const override {
    if constexpr (requires { grammar_.largest_size(); }) {
      return grammar_.largest_size();
    } else {
      return GrownModel::largest_size();
    }
  }
  void require_size(Size n) const override {
    if constexpr (requires(G& grammar) { grammar.require_size(n); }) G(grammar_).require_size(n);
  }
  std::uint64_t content_hash() const override {
    if constexpr (requires { grammar_.content_hash(); }) {
      return grammar_.content_hash();
    } else {
      return GrownModel::content_hash();
    }
  }

 private:
  static std::uint64_t number_of(const typename G::Label& label) {
    if constexpr (requires { label.size; }) {
      return label.size;
    } else {
      return label;
    }
  }

  // Copies that no tree uses are kept: one of formulas costs as much as a tree of some hundred nodes.
  std::unique_ptr<G> take() const {
    const std::lock_guard lock(mutex_);
    if (spare_.empty()) return std::make_unique<G>(grammar_);
    std::unique_ptr<G> copy = std::move(spare_.back());
    spare_.pop_back();
    return copy;
  }
  void give_back(std::unique_ptr<G> copy) const {
    const std::lock_guard lock(mutex_);
    spare_.push_back(std::move(copy));
  }

  G grammar_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<G>> spare_;
};

template <class G>
std::shared_ptr<const GrownModel> grown_model(G grammar) {
  return std::make_shared<const GrammarModel<G>>(std::move(grammar));
}

}  // namespace ramify
