#include "ramify/format/tree_table.hpp"

#include <algorithm>
#include <deque>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/parent_table.hpp"
#include "ramify/format/table_columns.hpp"

namespace ramify {
namespace {

std::string_view expected_columns(TableKind kind) {
  switch (kind) {
    case TableKind::edges:
      return "id,parent or parent,child";
    case TableKind::qsm:
      return "id, parent, radius and length";
    case TableKind::flowlines:
      return "id,toid or comid,tocomid or hydroseq,dnhydroseq or fromnode,tonode";
  }
  return {};
}

std::optional<TableColumns> columns_of(TableKind kind, const std::vector<std::string_view>& header) {
  switch (kind) {
    case TableKind::edges:
      return edge_columns(header);
    case TableKind::qsm:
      return qsm_columns(header);
    case TableKind::flowlines:
      return flowline_columns(header);
  }
  return std::nullopt;
}

ParentWords words_of(TableKind kind) {
  if (kind != TableKind::flowlines) return {};
  return {"a river that parts again is not a tree: each flowline drains to one",
          "keep the main paths alone (of NHDPlus the rows where StreamOrde = StreamCalc)"};
}

/// The rows of one tree, or of several that are told apart by their roots.
class TableReader {
 public:
  TableReader(SourceText source, TableKind kind, const TableColumns& columns)
      : source_(source), columns_(columns), table_(source, words_of(kind)) {
    if (columns.by_nodes) table_.allow_open_ends();
  }

  bool empty() const { return table_.size() == 0; }

  void add(const std::vector<std::string_view>& fields) {
    const std::string_view parent = fields[*columns_.parent];
    if (columns_.id) {
      if (fields[*columns_.id].empty())
        throw source_.error(fields[*columns_.id], "an empty id", "every node has one", "fill it in");
      table_.add(fields[*columns_.id], parent);
    } else {
      table_.add(row_numbers_.emplace_back(std::to_string(table_.size() + 1)), parent,
                 source_.offset(parent));
    }
    add_geometry(fields);
    if (columns_.name) names_.push_back(fields[*columns_.name]);
  }

  /// Hands the trees over, each named after the file, its number in it and its root.
  void finish(const std::string& name, const ReadOptions& options, std::vector<RecordedTree>& trees) {
    if (columns_.pairs) add_missing_parents();
    const auto found = table_.trees(options);
    for (const RowTree& rows : found) {
      trees.push_back(recorded(rows));
      trees.back().name = found.size() == 1 ? name : fmt::format("{}#{}", name, table_.id(rows.rows.front()));
    }
  }

 private:
  /// In a list of pairs the root is nobody's child.
  void add_missing_parents() {
    table_.add_missing_parents();
    const auto rows = table_.size();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (!lengths_.empty()) lengths_.resize(rows, none);
    if (!radii_.empty()) radii_.resize(rows, none);
    if (!names_.empty()) names_.resize(rows);
  }

  void add_geometry(const std::vector<std::string_view>& fields) {
    if (columns_.length) lengths_.push_back(measured(fields[*columns_.length], "length"));
    if (columns_.radius) {
      radii_.push_back(measured(fields[*columns_.radius], "radius"));
    } else if (columns_.diameter) {
      radii_.push_back(measured(fields[*columns_.diameter], "diameter") / 2);
    }
  }

  double measured(std::string_view field, std::string_view column) const {
    const double value = number_or_none(source_, field, column);
    if (value < 0)
      throw source_.error(field, fmt::format("{} = {}", column, field), "it is not negative",
                          "correct it, or leave the field empty");
    return value;
  }

  RecordedTree recorded(const RowTree& rows) const {
    RecordedTree tree{{}, rows.tree, in_preorder(lengths_, rows), in_preorder(radii_, rows), {}};
    for (std::size_t node = 0; node < rows.rows.size(); ++node) {
      const std::uint32_t row = rows.rows[node];
      const bool named = columns_.name && !names_[row].empty();
      if (!tree.names.set(node, named ? names_[row] : table_.id(row)))
        throw Error(fmt::format("{}: more than 4 GB of names", source_.name()), "they do not fit",
                    "shorten them");
    }
    return tree;
  }

  static std::vector<double> in_preorder(const std::vector<double>& values, const RowTree& rows) {
    std::vector<double> ordered;
    bool any = false;
    for (std::size_t node = 0; node < rows.rows.size() && !values.empty(); ++node) {
      ordered.push_back(values[rows.rows[node]]);
      any = any || ordered.back() == ordered.back();
    }
    return any ? ordered : std::vector<double>();
  }

  SourceText source_;
  TableColumns columns_;
  ParentTable table_;
  std::deque<std::string> row_numbers_;
  std::vector<double> lengths_, radii_;
  std::vector<std::string_view> names_;
};

void require_fields(const DelimitedRows& rows, std::size_t expected) {
  if (rows.fields().size() == expected) return;
  const std::string_view odd = rows.fields()[std::min(rows.fields().size() - 1, expected)];
  throw rows.source().error(odd, fmt::format("a row of {} field(s)", rows.fields().size()),
                            fmt::format("the first row has {}", expected), "give every row as many fields");
}

/// Rows parent, child[, length[, radius]] without a header.
TableColumns plain_edges(const DelimitedRows& rows) {
  const std::size_t fields = rows.fields().size();
  if (fields < 2 || fields > 4)
    throw rows.source().error(rows.fields().front(), fmt::format("a row of {} field(s)", fields),
                              "a list of edges without a header has parent, child[, length[, radius]]",
                              "name the columns in a first line");
  TableColumns columns;
  columns.parent = 0;
  columns.id = 1;
  columns.pairs = true;
  if (fields > 2) columns.length = 2;
  if (fields > 3) columns.radius = 3;
  return columns;
}

TableColumns read_columns(DelimitedRows& rows, TableKind kind) {
  if (auto columns = columns_of(kind, rows.fields())) {
    if (!rows.next())
      throw rows.source().error(rows.source().text().size(), "no rows", "a tree has a node at least",
                                "add rows below the header");
    return *columns;
  }
  if (kind == TableKind::edges) return plain_edges(rows);
  throw rows.source().error(rows.fields().front(), "columns are missing",
                            fmt::format("such a table has {}", expected_columns(kind)),
                            "name them in the first line");
}

}  // namespace

std::vector<RecordedTree> read_tree_table(SourceText source, TableKind kind, const ReadOptions& options) {
  DelimitedRows rows(source);
  if (!rows.next())
    throw source.error(source.text().size(), "no rows", "a tree has a node at least", "add rows");
  const std::size_t width = rows.fields().size();
  const TableColumns columns = read_columns(rows, kind);
  std::vector<RecordedTree> trees;
  std::string_view tree;
  TableReader reader(source, kind, columns);
  const auto name = [&] {
    return columns.tree ? fmt::format("{}:{}", source.name(), tree) : std::string(source.name());
  };
  do {
    require_fields(rows, width);
    const std::string_view next = columns.tree ? rows.fields()[*columns.tree] : std::string_view();
    if (next != tree && !reader.empty()) {
      reader.finish(name(), options, trees);
      reader = TableReader(source, kind, columns);
    }
    tree = next;
    reader.add(rows.fields());
  } while (rows.next());
  reader.finish(name(), options, trees);
  return trees;
}

bool announces_table(const std::vector<std::string_view>& header, TableKind& kind) {
  for (const TableKind candidate : {TableKind::flowlines, TableKind::qsm, TableKind::edges}) {
    kind = candidate;
    if (columns_of(candidate, header)) return true;
  }
  return false;
}

}  // namespace ramify
