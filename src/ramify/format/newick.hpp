#pragma once

#include <vector>

#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Reads Newick trees: `(a:1,(b,'c''s'):2[a comment])root;`, any number of them, each ended by a semicolon.
///
/// Any arity, one-child nodes and a leaf alone (`a;`) included; nodes need no labels. Quoted labels hold any
/// character, quotes doubled; of unquoted ones white space at the ends is left out, underscores stay.
/// Comments in brackets may stand anywhere, nested too, and are skipped, `[&R]` and `[&U]` among them. A
/// branch length stands for the branch above its node. A tree is named after the file, with the line where
/// there are several, and the column where several begin on one line.
///
/// Throws Error with line and column for unbalanced parentheses, an empty pair of them, a label or length
/// twice or out of place, a length that is no finite double, a quote or comment that is never closed, a text
/// that ends within a tree, and hybrid nodes (`#H1`: a network is no tree). O(length) time, no recursion.
std::vector<RecordedTree> read_newick(SourceText source);

/// One tree as Newick, with a line end: names as labels, or where it has none numbers for the external nodes,
/// 1 from the left; lengths where it has them. Radii are lost. O(nodes).
std::string write_newick(const RecordedTree& recorded);

}  // namespace ramify
