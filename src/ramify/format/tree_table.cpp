#include "ramify/format/tree_table.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <unordered_map>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/parent_table.hpp"
#include "ramify/format/table_layout.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify {
namespace {

ParentWords words_of(TableKind kind, std::string_view tree) {
  ParentWords words;
  if (!tree.empty()) words.tree = fmt::format("tree {}", excerpt(tree));
  if (kind == TableKind::flowlines) {
    words.duplicate_why = "a river that parts again is not a tree: each flowline drains to one";
    words.duplicate_remedy = "keep the main paths alone (of NHDPlus the rows where StreamOrde = StreamCalc)";
  }
  return words;
}

/// Takes rows out, given in ascending order.
template <class T>
void remove_rows(std::vector<T>& values, const std::vector<std::uint32_t>& rows) {
  std::vector<T> kept;
  auto next = rows.begin();
  for (std::uint32_t row = 0; row < values.size(); ++row) {
    if (next != rows.end() && *next == row) {
      ++next;
    } else {
      kept.push_back(values[row]);
    }
  }
  values = std::move(kept);
}

/// What the rows of a table have in common.
struct TableContext {
  SourceText source;
  TableKind kind;
  TableColumns columns;
  NumberStyle style;
};

/// The rows of one tree, or of several that are told apart by their roots.
class TableReader {
 public:
  TableReader(const TableContext& context, std::string_view tree)
      : context_(context), table_(context.source, words_of(context.kind, tree)) {
    if (context.columns.by_nodes) table_.allow_open_ends();
    name_ =
        tree.empty() ? std::string(context.source.name()) : fmt::format("{}:{}", context.source.name(), tree);
  }

  void add(const std::vector<std::string_view>& fields) {
    const TableColumns& columns = context_.columns;
    const std::string_view parent = fields[*columns.parent];
    if (columns.id) {
      if (fields[*columns.id].empty())
        throw context_.source.error(fields[*columns.id], "an empty id", "every node has one", "fill it in");
      table_.add(fields[*columns.id], parent);
    } else {
      table_.add(row_numbers_.emplace_back(std::to_string(table_.size() + 1)), parent,
                 context_.source.offset(parent));
    }
    add_geometry(fields);
    if (columns.name) names_.push_back(fields[*columns.name]);
  }

  /// Hands the trees over, each named after the file, its number in it and its root.
  void finish(const ReadOptions& options, std::vector<RecordedTree>& trees, Remarks& remarks) {
    if (context_.columns.pairs) add_missing_parents();
    if (context_.kind == TableKind::flowlines) drop_doubled_rows(remarks);
    const auto found = table_.trees(options, remarks);
    std::size_t missing_lengths = 0;
    for (const RowTree& rows : found) {
      trees.push_back(recorded(rows));
      missing_lengths += nodes_without_length(trees.back());
      trees.back().name =
          found.size() == 1 ? name_ : fmt::format("{}#{}", name_, table_.id(rows.rows.front()));
    }
    if (missing_lengths > 0)
      remarks.doubt(
          fmt::format("{}{} without a length", name_ == context_.source.name() ? "" : name_ + ": ",
                      missing_lengths == 1 ? "a node is" : fmt::format("{} nodes are", missing_lengths)));
  }

 private:
  /// In a list of pairs the root is nobody's child.
  void add_missing_parents() {
    table_.add_missing_parents();
    const auto rows = table_.size();
    constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();
    if (!lengths_.empty()) lengths_.resize(rows, unmeasured);
    if (!radii_.empty()) radii_.resize(rows, unmeasured);
    if (!names_.empty()) names_.resize(rows);
  }

  /// Joins with other tables double flowlines; a river parts only where the ends differ.
  void drop_doubled_rows(Remarks& remarks) {
    if (context_.columns.by_nodes) return;
    const auto doubled = table_.doubled_rows();
    if (doubled.empty()) return;
    std::unordered_map<std::string_view, std::uint32_t> first;
    for (std::uint32_t row = 0; row < table_.size(); ++row) first.emplace(table_.id(row), row);
    const auto differ = [](const std::vector<double>& values, std::uint32_t a, std::uint32_t b) {
      return !values.empty() && values[a] != values[b] && (values[a] == values[a] || values[b] == values[b]);
    };
    for (const std::uint32_t row : doubled) {
      const std::uint32_t other = first.at(table_.id(row));
      if (differ(lengths_, row, other) || differ(radii_, row, other)) return;  // trees() refuses the second
    }
    table_.remove(doubled);
    remove_rows(lengths_, doubled);
    remove_rows(radii_, doubled);
    remove_rows(names_, doubled);
    remarks.ignore("row", "that doubles another (same id, same end)", doubled.size());
  }

  void add_geometry(const std::vector<std::string_view>& fields) {
    const TableColumns& columns = context_.columns;
    if (columns.length) lengths_.push_back(measured(fields[*columns.length], "length"));
    if (columns.radius) {
      radii_.push_back(measured(fields[*columns.radius], "radius"));
    } else if (columns.diameter) {
      radii_.push_back(measured(fields[*columns.diameter], "diameter") / 2);
    }
  }

  double measured(std::string_view field, std::string_view column) const {
    const double value = number_or_none(context_.source, context_.style, field, column);
    if (value < 0)
      throw context_.source.error(field, fmt::format("{} = {}", column, field), "it is not negative",
                                  "correct it, or leave the field empty");
    return value;
  }

  RecordedTree recorded(const RowTree& rows) const {
    RecordedTree tree{{}, rows.tree, in_preorder(lengths_, rows), in_preorder(radii_, rows), {}};
    for (std::size_t node = 0; node < rows.rows.size(); ++node) {
      const std::uint32_t row = rows.rows[node];
      const bool named = !names_.empty() && !is_missing(names_[row]);
      if (!tree.names.set(node, named ? names_[row] : table_.id(row)))
        throw Error(fmt::format("{}: more than 4 GB of names", context_.source.name()), "they do not fit",
                    "shorten them");
    }
    return tree;
  }

  /// In a tree that has lengths every node has one; the root need not.
  static std::size_t nodes_without_length(const RecordedTree& tree) {
    if (tree.lengths.empty()) return 0;
    return static_cast<std::size_t>(std::count_if(tree.lengths.begin() + 1, tree.lengths.end(),
                                                  [](double length) { return std::isnan(length); }));
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

  const TableContext& context_;
  std::string name_;
  ParentTable table_;
  std::deque<std::string> row_numbers_;
  std::vector<double> lengths_, radii_;
  std::vector<std::string_view> names_;
};

/// The trees of a table, in the order in which they begin.
class TreesByName {
 public:
  explicit TreesByName(const TableContext& context) : context_(context) {}

  TableReader& operator[](std::string_view tree) {
    const auto [found, is_new] = place_.emplace(keys_(tree), readers_.size());
    if (is_new) readers_.emplace_back(context_, tree);
    return readers_[found->second];
  }

  std::deque<TableReader>& readers() { return readers_; }

 private:
  const TableContext& context_;
  IdKeys keys_;
  std::unordered_map<std::string_view, std::size_t> place_;
  std::deque<TableReader> readers_;
};

}  // namespace

std::vector<RecordedTree> read_tree_table(SourceText source, TableKind kind, const ReadOptions& options,
                                          Remarks& remarks) {
  DelimitedRows rows(source);
  if (!rows.next())
    throw source.error(source.text().size(), "no rows", "a tree has a node at least", "add rows");
  const detail::TableLayout layout = detail::read_table_layout(rows, kind);
  const TableColumns& columns = layout.columns;
  const TableContext context{source, kind, columns,
                             style_of(rows, {columns.length, columns.radius, columns.diameter})};
  TreesByName trees(context);
  do {
    detail::require_fields(rows, layout.header.size());
    trees[columns.tree ? rows.fields()[*columns.tree] : std::string_view()].add(rows.fields());
  } while (rows.next());
  std::vector<RecordedTree> found;
  for (TableReader& reader : trees.readers()) reader.finish(options, found, remarks);
  detail::remark_ignored(layout, remarks);
  return found;
}

}  // namespace ramify
