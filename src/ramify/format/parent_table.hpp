#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ramify/format/read_options.hpp"
#include "ramify/text/source_text.hpp"
#include "ramify/tree/tree.hpp"

namespace ramify {

/// A tree out of a table of parents: node by node in preorder, the row that it came from.
struct RowTree {
  Tree tree;
  std::vector<std::uint32_t> rows;
};

/// What is said of a table that is no tree.
struct ParentWords {
  std::string_view duplicate_why = "each node has one row";
  std::string_view duplicate_remedy = "remove one, or give them different ids";
};

/// Rows of (id, parent id) in any order, turned into trees. The children of a node come in the order of their
/// rows.
///
/// Ids are compared as text. Throws Error with line and column for an id used twice, a node that is its own
/// parent, a parent that has no row, a cycle (naming a node of it), and several roots where one is needed.
class ParentTable {
 public:
  explicit ParentTable(SourceText source, ParentWords words = {}) : source_(source), words_(words) {}

  /// Adds a row; both are parts of the source text, which say where they stand. A parent that is empty, 0,
  /// -1, NA or none makes a root, unless a node has that id.
  void add(std::string_view id, std::string_view parent) {
    rows_.push_back({id, parent, source_.offset(id), source_.offset(parent)});
  }
  /// Adds a row whose ids are kept elsewhere, and outlive the table.
  void add(std::string_view id, std::string_view parent, std::size_t place) {
    rows_.push_back({id, parent, place, place});
  }
  /// Adds a root row for every parent that has none.
  void add_missing_parents();
  std::size_t size() const { return rows_.size(); }
  std::string_view id(std::size_t row) const { return rows_[row].id; }

  /// Parents that have no row make roots, as where a river leaves the map.
  void allow_open_ends() { open_ends_ = true; }

  /// One tree, or with root = "all" one for every root, in the order of their rows. With any choice of a root
  /// parents may be missing. O(rows) time.
  std::vector<RowTree> trees(const ReadOptions& options) const;

 private:
  struct Row {
    std::string_view id, parent;
    std::size_t id_place, parent_place;
  };
  static constexpr std::uint32_t no_row = UINT32_MAX;

  std::vector<std::uint32_t> parent_rows(bool parents_may_be_missing) const;
  void require_no_cycle(const std::vector<std::uint32_t>& parents) const;
  std::vector<std::uint32_t> chosen_roots(const std::vector<std::uint32_t>& parents,
                                          const std::string& root) const;

  SourceText source_;
  ParentWords words_;
  bool open_ends_ = false;
  std::vector<Row> rows_;
};

}  // namespace ramify
