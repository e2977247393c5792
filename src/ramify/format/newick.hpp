#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ramify/text/remarks.hpp"
#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Reads Newick trees: `(a:1,(b,'c''s'):2[a comment])root;`, any number of them, each ended by a semicolon.
///
/// Any arity, one-child nodes and a leaf alone (`a;`) included; nodes need no labels. Labels that begin with
/// a quote of either kind hold any character, quotes doubled; of others white space at the ends is left out,
/// underscores stay and apostrophes are letters. Comments in brackets may stand anywhere, nested too, and are
/// skipped, `[&R]` and `[&U]` among them. A branch length stands for the branch above its node; nan, NA or
/// nothing behind the colon is none. Marks of branches (`#1`, `$1` of PAML, `{...}` of HyPhy and placements)
/// are skipped, and so is a line of counts before the first tree. A tree is named after the file, with its
/// own name, `name(...);`, or the line where there are several, and the column where several begin on one
/// line. What is skipped, and lengths that are missing, are remarked.
///
/// Throws Error with line and column for unbalanced parentheses, an empty pair of them, a label or length
/// twice or out of place, a length that is no finite double, a quote or comment that is never closed, a text
/// that ends within a tree, and hybrid nodes (`#H1` at two places: a network is no tree). O(length) time, no
/// recursion.
std::vector<RecordedTree> read_newick(SourceText source, Remarks& remarks);

/// Where the tree begins after a line of one or two counts, as PAML and PHYLIP write it; 0 where none is
/// there.
std::size_t newick_count_line(std::string_view text);

/// One tree as Newick, with a line end: names as labels, or where it has none numbers for the external nodes,
/// 1 from the left; lengths where it has them. Radii are lost. O(nodes).
std::string write_newick(const RecordedTree& recorded);

}  // namespace ramify
