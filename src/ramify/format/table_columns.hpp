#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ramify {

/// Where a table of a tree has what: the place of each column that is read.
struct TableColumns {
  std::optional<std::size_t> tree, id, parent, length, radius, diameter, name;
  bool pairs = false;     ///< parent, child: a parent need not have a row
  bool by_nodes = false;  ///< flowlines as (from node, to node): ends without a row are outlets
};

/// The name of a column in lower case without its unit: "Length_mm" is "length".
std::string plain_column(std::string_view column);

/// The columns of a river table; nothing where it has none of the pairs of ids.
std::optional<TableColumns> flowline_columns(const std::vector<std::string_view>& header);
/// Those of a table of cylinders: id may be missing, radius and length may not.
std::optional<TableColumns> qsm_columns(const std::vector<std::string_view>& header);
/// Those of any other table of nodes and parents.
std::optional<TableColumns> edge_columns(const std::vector<std::string_view>& header);

}  // namespace ramify
