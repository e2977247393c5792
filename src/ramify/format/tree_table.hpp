#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ramify/format/read_options.hpp"
#include "ramify/text/remarks.hpp"
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

/// Reads one; column names are matched as table_columns.hpp does. Rows with the same entry in a column
/// `tree`, wherever they stand, are a tree. Every row may have one field before those of the header (the row
/// names of R). The header may be missing: then edges are parent, child[, length[, radius]], cylinders what
/// TreeQSM exports (is_treeqsm). Of flowlines that are there twice with the same end and geometry one is
/// read. What is not read is remarked.
///
/// Throws Error with line and column where columns are missing, rows have other lengths than the header,
/// numbers are none or negative, or the rows make no tree (parent_table.hpp). O(size) time.
std::vector<RecordedTree> read_tree_table(SourceText source, TableKind kind, const ReadOptions& options,
                                          Remarks& remarks);

/// What kind of table a header announces: flowlines before qsm before edges; nothing where none.
std::optional<TableKind> announced_table(const std::vector<std::string_view>& header);

/// A row without a header as TreeQSM's save_model_text exports it: 15 or 17 numbers, radius and length first,
/// start and axis, then parent and extension, which are whole.
bool is_treeqsm(const std::vector<std::string_view>& fields);

}  // namespace ramify
