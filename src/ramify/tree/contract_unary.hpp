#pragma once

#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// The tree without its one-child nodes: a chain of them and the node that ends it (a fork or a tip) become
/// one node, which keeps the name and place of that last one.
///
/// Lengths along a chain are added, and its radius is the mean of the radii weighted by length: plain where
/// no length in the chain is known or above 0. Values that are NaN are left out of both; NaN where all are. A
/// chain above a tip becomes the tip. O(nodes).
RecordedTree contract_unary(RecordedTree tree);

}  // namespace ramify
