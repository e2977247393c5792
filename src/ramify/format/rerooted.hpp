#pragma once

#include <cstddef>

#include "ramify/format/parent_table.hpp"

namespace ramify::detail {

/// The same tree with another of its nodes, given by its preorder place, as the root: the edges between the
/// two turn round. Children stay in the order of their rows. O(nodes).
RowTree rerooted(const RowTree& tree, std::size_t node);

}  // namespace ramify::detail
