#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ramify/core/contract.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// A stored ordered tree: the number of children of every node, in preorder (the Lukasiewicz word).
///
/// Any arity; 4 bytes a node. Node ids are preorder positions, so tables of node attributes are plain vectors
/// beside it. A well-formed word has sum(arity) = nodes - 1 with every proper prefix short of its last node.
class Tree {
 public:
  Tree() = default;

  /// Takes a well-formed word (checked by contract).
  explicit Tree(std::vector<std::uint32_t> arity) : arity_(std::move(arity)) {
    RAMIFY_EXPECTS(is_well_formed(arity_));
  }

  static bool is_well_formed(std::span<const std::uint32_t> arity);

  std::size_t node_count() const { return arity_.size(); }
  std::uint32_t arity(std::size_t node) const { return arity_[node]; }
  std::span<const std::uint32_t> arities() const { return arity_; }

  /// Internal nodes: n.
  Size size() const;

  friend bool operator==(const Tree&, const Tree&) = default;

 private:
  std::vector<std::uint32_t> arity_;
};

}  // namespace ramify
