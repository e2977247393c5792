#include "ramify/format/parent_table.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

#include "ramify/text/trimmed.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify {
namespace {

/// The rows below every row, in their order, as one array: those of row r from begin[r] to begin[r + 1].
struct Children {
  std::vector<std::uint32_t> begin, rows;
};

Children children_of(const std::vector<std::uint32_t>& parents) {
  Children children{std::vector<std::uint32_t>(parents.size() + 2, 0), {}};
  std::size_t edges = 0;
  for (const std::uint32_t parent : parents) {
    if (parent >= parents.size()) continue;
    ++children.begin[parent + 2];
    ++edges;
  }
  for (std::size_t i = 2; i < children.begin.size(); ++i) children.begin[i] += children.begin[i - 1];
  children.rows.resize(edges);
  for (std::uint32_t row = 0; row < parents.size(); ++row)
    if (parents[row] < parents.size()) children.rows[children.begin[parents[row] + 1]++] = row;
  return children;
}

RowTree tree_below(std::uint32_t root, const Children& children) {
  std::vector<std::uint32_t> arity, rows, pending{root};
  while (!pending.empty()) {
    const std::uint32_t row = pending.back();
    pending.pop_back();
    rows.push_back(row);
    const std::uint32_t first = children.begin[row], last = children.begin[row + 1];
    arity.push_back(last - first);
    for (std::uint32_t i = last; i-- > first;) pending.push_back(children.rows[i]);
  }
  return {Tree(std::move(arity)), std::move(rows)};
}

/// What tables write for "none", unless a node has that id.
bool means_none(std::string_view parent_key) {
  return parent_key == "0" || parent_key == "-1" || is_missing(parent_key);
}

}  // namespace

void ParentTable::add_missing_parents() {
  IdKeys keys;
  std::unordered_set<std::string_view> ids;
  for (const Row& row : rows_) ids.insert(keys(row.id));
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Row child = rows_[row];
    const std::string_view parent = keys(child.parent);
    const bool is_node = parent == "0" || !means_none(parent);
    if (is_node && ids.insert(parent).second)
      rows_.push_back({child.parent, child.parent.substr(0, 0), child.parent_place, child.parent_place});
  }
}

std::vector<std::uint32_t> ParentTable::doubled_rows() const {
  IdKeys keys;
  std::unordered_map<std::string_view, std::uint32_t> row_of;
  std::vector<std::uint32_t> doubled;
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    const auto [first, is_new] = row_of.emplace(keys(rows_[row].id), row);
    if (!is_new && keys(rows_[first->second].parent) == keys(rows_[row].parent)) doubled.push_back(row);
  }
  return doubled;
}

void ParentTable::remove(const std::vector<std::uint32_t>& rows) {
  std::vector<Row> kept;
  auto next = rows.begin();
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    if (next != rows.end() && *next == row) {
      ++next;
    } else {
      kept.push_back(rows_[row]);
    }
  }
  rows_ = std::move(kept);
}

void ParentTable::refuse_second(const Row& row, const Row& first, bool same_parent) const {
  const std::size_t line = source_.at(first.id_place).line;
  if (trimmed(row.id) != trimmed(first.id))
    throw source_.error(row.id_place,
                        fmt::format("{}ids {} and {} (line {}) are one number", prefix(), excerpt(row.id),
                                    excerpt(first.id), line),
                        "ids that are numbers are told apart by their values",
                        "write one of them differently");
  const std::string problem = fmt::format("{}id {} twice, first in line {}", prefix(), excerpt(row.id), line);
  if (same_parent)
    throw source_.error(row.id_place, problem, "both rows have the same parent: one is doubled",
                        "remove one of them");
  throw source_.error(row.id_place, problem, words_.duplicate_why, words_.duplicate_remedy);
}

std::vector<std::uint32_t> ParentTable::parent_rows(bool parents_may_be_missing, bool any_loops) const {
  IdKeys keys;
  std::unordered_map<std::string_view, std::uint32_t> row_of;
  row_of.reserve(rows_.size());
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    const auto [first, is_new] = row_of.emplace(keys(rows_[row].id), row);
    if (is_new) continue;
    const Row& earlier = rows_[first->second];
    refuse_second(rows_[row], earlier, keys(earlier.parent) == keys(rows_[row].parent));
  }
  std::vector<std::uint32_t> parents(rows_.size(), no_row);
  std::uint32_t own_parent = no_row;
  bool other_root = false;
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    const auto& [id, parent, id_place, parent_place] = rows_[row];
    const std::string_view key = keys(parent);
    const auto found = key.empty() ? row_of.end() : row_of.find(key);
    if (found != row_of.end()) {
      parents[row] = found->second == row ? no_row : found->second;
      if (found->second == row) own_parent = own_parent == no_row ? row : own_parent;
    } else if (!parents_may_be_missing && !means_none(key)) {
      throw source_.error(
          parent_place,
          fmt::format("{}parent {} of node {} has no row", prefix(), excerpt(parent), excerpt(id)),
          "every parent is a node itself",
          fmt::format("add its row, or take what lies above node {0} with --root {0}", excerpt(id)));
    } else {
      other_root = true;
    }
  }
  if (own_parent != no_row && other_root && !any_loops)
    throw source_.error(rows_[own_parent].id_place,
                        fmt::format("{}node {} is its own parent", prefix(), excerpt(rows_[own_parent].id)),
                        "a tree has no loops, and another node is the root",
                        "correct the parent, or leave it empty for the root");
  return parents;
}

void ParentTable::refuse_cycle(std::uint32_t row, const std::vector<std::uint32_t>& parents) const {
  std::size_t length = 1;
  for (std::uint32_t on = parents[row]; on != row; on = parents[on]) ++length;
  throw source_.error(
      rows_[row].id_place,
      fmt::format("{}a cycle of {} nodes through node {}", prefix(), length, excerpt(rows_[row].id)),
      "going from parent to parent must end at a root",
      "correct the parent of one of them, or take a sound part with --root ID");
}

void ParentTable::require_no_cycle(const std::vector<std::uint32_t>& parents) const {
  enum class State : std::uint8_t { unseen, on_path, done };
  std::vector<State> states(parents.size(), State::unseen);
  for (std::uint32_t start = 0; start < parents.size(); ++start) {
    std::uint32_t row = start;
    for (; row != no_row && states[row] == State::unseen; row = parents[row]) states[row] = State::on_path;
    if (row != no_row && states[row] == State::on_path) refuse_cycle(row, parents);
    for (row = start; row != no_row && states[row] == State::on_path; row = parents[row])
      states[row] = State::done;
  }
}

/// What hangs on a node is a tree unless the node itself is on a cycle.
void ParentTable::require_no_cycle_through(std::uint32_t root,
                                           const std::vector<std::uint32_t>& parents) const {
  std::uint32_t row = parents[root];
  for (std::size_t steps = 0; row != no_row && steps < parents.size(); ++steps, row = parents[row])
    if (row == root) refuse_cycle(root, parents);
}

std::uint32_t ParentTable::row_with(const std::string& root) const {
  IdKeys keys;
  const std::string_view wanted = keys(root);
  for (std::uint32_t row = 0; row < rows_.size(); ++row)
    if (keys(rows_[row].id) == wanted) return row;
  throw Error(fmt::format("{}: {}--root {}", source_.name(), prefix(), root), "no node has that id",
              "give an id of the table");
}

std::vector<std::uint32_t> ParentTable::all_roots(const std::vector<std::uint32_t>& parents,
                                                  const std::string& root) const {
  std::vector<std::uint32_t> roots;
  for (std::uint32_t row = 0; row < parents.size(); ++row)
    if (parents[row] == no_row) roots.push_back(row);
  if (root.empty() && roots.size() > 1)
    throw source_.error(
        rows_[roots[1]].id_place,
        fmt::format("{}{} roots, among them {} and {}", prefix(), roots.size(), excerpt(rows_[roots[0]].id),
                    excerpt(rows_[roots[1]].id)),
        "a tree has one",
        fmt::format("take one with --root {}, or {}", excerpt(rows_[roots[0]].id), words_.more_roots));
  return roots;
}

std::vector<RowTree> ParentTable::trees(const ReadOptions& options, Remarks& remarks) const {
  if (rows_.size() >= no_row)
    throw Error(fmt::format("{}: {} rows", source_.name(), rows_.size()), "at most 4*10^9 fit",
                "cut the table");
  if (rows_.empty())
    throw source_.error(source_.text().size(), "no rows", "a tree has a node at least", "add rows");
  const bool one_root = !options.root.empty() && options.root != "all";
  const auto parents = parent_rows(open_ends_ || !options.root.empty(), one_root);
  if (one_root) {
    const std::uint32_t root = row_with(options.root);
    require_no_cycle_through(root, parents);
    std::vector<RowTree> tree{tree_below(root, children_of(parents))};
    remarks.ignore("row", fmt::format("not below {}", options.root), rows_.size() - tree[0].rows.size());
    return tree;
  }
  require_no_cycle(parents);
  const Children children = children_of(parents);
  std::vector<RowTree> trees;
  for (const std::uint32_t root : all_roots(parents, options.root))
    trees.push_back(tree_below(root, children));
  return trees;
}

}  // namespace ramify
