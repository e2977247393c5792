#pragma once

#include <string_view>
#include <vector>

#include "ramify/text/remarks.hpp"
#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Reads the blocks TREES of a NEXUS file (Maddison, Swofford and Maddison 1997): every `TREE name = newick;`
/// with the labels of its `TRANSLATE` table in place of its own. Trees are named "file:name", the one tree of
/// a file after the file. Other blocks are remarked.
///
/// Throws Error with line and column where no block has trees, a command or block is cut off, and for
/// whatever read_newick refuses. O(length) time.
std::vector<RecordedTree> read_nexus(SourceText source, Remarks& remarks);

/// "#NEXUS" in any case.
bool is_nexus(std::string_view text);

}  // namespace ramify
