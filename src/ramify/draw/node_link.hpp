#pragma once

#include <optional>
#include <string>

#include "ramify/draw/drawing.hpp"
#include "ramify/draw/node_number.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// How a node-link diagram looks.
struct NodeLinkStyle {
  enum class Form {
    dendrogram,  ///< root at the left, branches with right angles
    upright,     ///< root at the bottom, straight branches
  };

  Form form = Form::dendrogram;
  unsigned leaf_order = 0;    ///< of the tips, in the key: 0 or 1
  bool same_lengths = false;  ///< every branch as long as another, whatever the tree says
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::optional<NodeNumber> number = {};  ///< written at every node
};

/// "dendrogram" or "upright"; throws Error for another, with the nearest.
NodeLinkStyle::Form parse_form(const std::string& name);

/// The diagram of a tree: branches coloured and widened by the Horton-Strahler order of the node they lead
/// to, to scale with a bar where the tree has lengths; names at the tips up to most_named_tips; the tree's
/// name and a key of the orders above.
///
/// Throws Error where a length is not known, negative or infinite; the root's own may be unknown; and for
/// numbers at the nodes of a tree of more than most_named_tips tips. O(nodes).
Drawing node_link_diagram(const RecordedTree& tree, const NodeLinkStyle& style);

/// Every length is known (but the root's), not negative, and so is their sum: the diagram can be to scale.
bool has_drawable_lengths(const RecordedTree& tree);

inline constexpr std::size_t most_named_tips = 300;

}  // namespace ramify
