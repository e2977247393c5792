#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ramify {

/// Where a table of a tree has what: the place of each column that is read.
struct TableColumns {
  std::optional<std::size_t> tree, id, parent, length, radius, diameter, name;
  std::optional<std::size_t> type, x, y, z;  ///< of points (SWC)
  bool pairs = false;                        ///< parent, child: a parent need not have a row
  bool by_nodes = false;  ///< flowlines as (from node, to node): ends without a row are outlets

  /// Whether a column is one of them.
  bool uses(std::size_t column) const;
};

/// The name of a column as it is looked up: in lower case, letters and digits alone, without its unit:
/// "Length_mm", "length (m)" and "branch.length" are "length", "length" and "branchlength".
std::string plain_column(std::string_view column);

/// The usual names of a column that is read, as plain_column() gives them; the first that a header has is
/// taken.
enum class ColumnRole { tree, length, radius, diameter, area, name, order, count, leaf_order };
std::optional<std::size_t> find_column(const std::vector<std::string>& plain_header, ColumnRole role);

/// The columns of a river table; nothing where it has none of the pairs of ids.
std::optional<TableColumns> flowline_columns(const std::vector<std::string_view>& header);
/// Those of a table of cylinders: id may be missing, radius and length may not.
std::optional<TableColumns> qsm_columns(const std::vector<std::string_view>& header);
/// Those of a table of points, as SWC has them: id, x, y, z, parent; type and radius or diameter may be
/// missing, a length may not be there unless there is a type.
std::optional<TableColumns> point_columns(const std::vector<std::string_view>& header);
/// Those of any other table of nodes and parents.
std::optional<TableColumns> edge_columns(const std::vector<std::string_view>& header);

}  // namespace ramify
