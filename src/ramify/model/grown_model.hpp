#pragma once

#include <cstdint>
#include <memory>
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
  virtual Tree grow(Size n, Stream& stream, const Cancellation& cancellation) const = 0;

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
///   of an external
///                                one
///   g.expected_nodes(n), g.largest_order(n), and g.largest_size(), g.content_hash() where they are not the
///   default: as of
///                                GrownModel
template <class G>
class GrammarModel final : public GrownModel {
 public:
  explicit GrammarModel(G grammar) : grammar_(std::move(grammar)) {}

  Tree grow(Size n, Stream& stream, const Cancellation& cancellation) const override {
    constexpr std::size_t nodes_between_looks = std::size_t{1} << 20;
    std::vector<std::uint32_t> arity;
    std::vector<typename G::Label> pending{grammar_.root(n)}, children;
    while (!pending.empty()) {
      if (arity.size() % nodes_between_looks == 0 && cancellation.requested()) throw Interrupted();
      const auto label = pending.back();
      pending.pop_back();
      children.clear();
      grammar_.children(label, stream, children);
      arity.push_back(static_cast<std::uint32_t>(children.size()));
      pending.insert(pending.end(), children.rbegin(), children.rend());
    }
    return Tree(std::move(arity));
  }

  double expected_nodes(Size n) const override { return grammar_.expected_nodes(n); }
  std::size_t largest_order(Size n) const override { return grammar_.largest_order(n); }
  Size largest_size() const override {
    if constexpr (requires { grammar_.largest_size(); }) {
      return grammar_.largest_size();
    } else {
      return GrownModel::largest_size();
    }
  }
  std::uint64_t content_hash() const override {
    if constexpr (requires { grammar_.content_hash(); }) {
      return grammar_.content_hash();
    } else {
      return GrownModel::content_hash();
    }
  }

 private:
  G grammar_;
};

template <class G>
std::shared_ptr<const GrownModel> grown_model(G grammar) {
  return std::make_shared<const GrammarModel<G>>(std::move(grammar));
}

}  // namespace ramify
