#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/format/read_options.hpp"
#include "ramify/format/tree_format.hpp"
#include "ramify/text/remarks.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// The trees of a text, one at least, in the order of the file; one-child nodes are kept
/// (contract_unary.hpp).
///
/// @param name     names the trees, and the file in messages
/// @param format   nothing: found by content
/// @param remarks  is told what is not read, and what is doubtful
/// Throws Error, one line with file:line:column, for whatever is no such file; each reader's header says what
/// it refuses. O(length) time; for Newick some 30 bytes a node.
std::vector<RecordedTree> read_trees(std::string_view text, std::string_view name,
                                     std::optional<TreeFormat> format, const ReadOptions& options,
                                     Remarks& remarks);

/// The text of a file, of standard input where the path is "-", unpacked where it is gzip. Throws Error where
/// it cannot be read.
std::string read_tree_file(const std::string& path);

}  // namespace ramify
