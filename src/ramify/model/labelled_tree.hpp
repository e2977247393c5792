#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ramify/model/model.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// A tree as it was grown: its shape, and the number that the grammar told every node by.
struct LabelledTree {
  Tree tree;
  std::vector<std::uint64_t> labels;  ///< by preorder place; none of a model whose nodes carry none
  std::string_view meaning;  ///< "internal nodes from it down", "strings below", "order, leaf order 0"
};

/// The tree that a model grows from a stream, the same as without labels; 12 bytes a node. Throws Interrupted
/// when a tree that is grown whole is cancelled.
LabelledTree grow_labelled(const Model& model, Size n, Stream& stream, const Cancellation& cancellation);

}  // namespace ramify
