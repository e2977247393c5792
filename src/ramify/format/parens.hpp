#pragma once

#include <string>
#include <vector>

#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Reads trees as words of E and (LR) (tree/parenthesis_word.hpp), one a line; empty lines are skipped. A
/// tree is named after the file, with the line where there are several. Throws Error with line and column.
/// O(length).
std::vector<RecordedTree> read_parens(SourceText source);

/// One word with a line end. Branching alone is kept of a tree. O(nodes).
std::string write_parens(const RecordedTree& tree);

}  // namespace ramify
