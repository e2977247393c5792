#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/table_columns.hpp"
#include "ramify/format/tree_table.hpp"

namespace ramify::detail {

/// Where the columns of a table stand in its rows.
struct TableLayout {
  TableColumns columns;
  std::vector<std::string_view> header;  ///< a name for every field of a row; empty where it has none
};

/// The layout that the first rows of a table give; afterwards `rows` stands at its first row of data. Throws
/// Error where columns are missing, or there is no row.
TableLayout read_table_layout(DelimitedRows& rows, TableKind kind);

/// The same of a table with such columns in a header where `rows` stands.
TableLayout layout_below_header(DelimitedRows& rows,
                                std::optional<TableColumns> (*find)(const std::vector<std::string_view>&));

/// Whether every row has one field before those of the header, as R writes the names of rows: an empty field
/// too many at the end of all rows is none. `rows` stands at its first row of data.
bool has_row_names(DelimitedRows rows, std::size_t columns);

/// Remarks columns that are not read, by their names.
void remark_columns(const std::vector<std::string_view>& names, Remarks& remarks);
/// Those of a layout that its columns do not use.
void remark_ignored(const TableLayout& layout, Remarks& remarks);

/// Throws Error where a row has other fields than the layout; empty ones at its end do not count.
void require_fields(const DelimitedRows& rows, std::size_t expected);

}  // namespace ramify::detail
