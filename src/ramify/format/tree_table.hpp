#pragma once

#include <string_view>
#include <vector>

#include "ramify/format/read_options.hpp"
#include "ramify/text/source_text.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// The three kinds of tables of (node, parent) that have a header; they differ in the names of their columns
/// and in what an error says.
enum class TableKind {
  edges,      ///< id, parent or parent, child; without a header parent, child
  qsm,        ///< cylinders: id, parent, radius, length (rTwig, SimpleForest, aRchi; TreeQSM by row number)
  flowlines,  ///< rivers, downstream: id, toid; comid, tocomid; hydroseq, dnhydroseq; fromnode, tonode
};

/// Reads one; column names are matched without regard to case and unit ("length_mm"). A column `tree` parts
/// the rows into several tables. Other columns are ignored.
///
/// Throws Error with line and column where columns are missing, rows have other lengths than the header,
/// numbers are none or negative, or the rows make no tree (parent_table.hpp). O(size) time.
std::vector<RecordedTree> read_tree_table(SourceText source, TableKind kind, const ReadOptions& options);

/// What kind of table a header announces: flowlines before qsm before edges; false where none.
bool announces_table(const std::vector<std::string_view>& header, TableKind& kind);

}  // namespace ramify
