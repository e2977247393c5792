#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/format/read_options.hpp"
#include "ramify/text/remarks.hpp"
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
  std::string_view more_roots = "each as a tree of its own with --root all";
  std::string tree;  ///< of which tree in the file; empty for the whole
};

/// Rows of (id, parent id) in any order, turned into trees. The children of a node come in the order of their
/// rows.
///
/// Ids are compared as IdKeys does. Throws Error with line and column for an id used twice or written in two
/// ways, a node that is its own parent beside a root, a parent that has no row, a cycle (naming a node of
/// it), and several roots where one is needed.
class ParentTable {
 public:
  explicit ParentTable(SourceText source, ParentWords words = {})
      : source_(source), words_(std::move(words)) {}

  /// Adds a row; both are parts of the source text, which say where they stand. A parent that is missing
  /// (is_missing), 0 or -1 makes a root, unless a node has that id; so does a node that is its own parent
  /// where no other root is there.
  void add(std::string_view id, std::string_view parent) {
    rows_.push_back({id, parent, source_.offset(id), source_.offset(parent)});
  }
  /// Adds a row whose ids are kept elsewhere, and outlive the table.
  void add(std::string_view id, std::string_view parent, std::size_t place) {
    rows_.push_back({id, parent, place, place});
  }
  /// Adds a root row for every parent that has none.
  void add_missing_parents();
  /// Of rows with the same id and parent those after the first, in ascending order.
  std::vector<std::uint32_t> doubled_rows() const;
  /// Removes rows, given in ascending order.
  void remove(const std::vector<std::uint32_t>& rows);

  std::size_t size() const { return rows_.size(); }
  std::string_view id(std::size_t row) const { return rows_[row].id; }

  /// Parents that have no row make roots, as where a river leaves the map.
  void allow_open_ends() { open_ends_ = true; }

  /// One tree, or with root = "all" one for every root, in the order of their rows. With any choice of a root
  /// parents may be missing; with the id of one, cycles elsewhere too, and the rows that are not below it are
  /// remarked. O(rows) time.
  std::vector<RowTree> trees(const ReadOptions& options, Remarks& remarks) const;

 private:
  struct Row {
    std::string_view id, parent;
    std::size_t id_place, parent_place;
  };
  static constexpr std::uint32_t no_row = UINT32_MAX;

  std::vector<std::uint32_t> parent_rows(bool parents_may_be_missing, bool any_loops) const;
  [[noreturn]] void refuse_second(const Row& row, const Row& first, bool same_parent) const;
  void require_no_cycle(const std::vector<std::uint32_t>& parents) const;
  void require_no_cycle_through(std::uint32_t root, const std::vector<std::uint32_t>& parents) const;
  [[noreturn]] void refuse_cycle(std::uint32_t row, const std::vector<std::uint32_t>& parents) const;
  std::uint32_t row_with(const std::string& root) const;
  std::vector<std::uint32_t> all_roots(const std::vector<std::uint32_t>& parents,
                                       const std::string& root) const;
  std::string prefix() const { return words_.tree.empty() ? "" : words_.tree + ": "; }

  SourceText source_;
  ParentWords words_;
  bool open_ends_ = false;
  std::vector<Row> rows_;
};

}  // namespace ramify
