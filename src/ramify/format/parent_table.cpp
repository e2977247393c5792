#include "ramify/format/parent_table.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

#include <fmt/format.h>

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
bool means_none(std::string_view parent) {
  constexpr std::array<std::string_view, 8> words{"0", "-1", "NA", "NaN", "nan", "none", "None", "null"};
  return parent.empty() || std::ranges::find(words, parent) != words.end();
}

}  // namespace

void ParentTable::add_missing_parents() {
  std::unordered_set<std::string_view> ids;
  for (const Row& row : rows_) ids.insert(row.id);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Row& child = rows_[row];
    const bool is_node = child.parent == "0" || !means_none(child.parent);
    if (is_node && ids.insert(child.parent).second)
      rows_.push_back({child.parent, child.parent.substr(0, 0), child.parent_place, child.parent_place});
  }
}

std::vector<std::uint32_t> ParentTable::parent_rows(bool parents_may_be_missing) const {
  std::unordered_map<std::string_view, std::uint32_t> row_of;
  row_of.reserve(rows_.size());
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    const auto [first, is_new] = row_of.emplace(rows_[row].id, row);
    if (is_new) continue;
    throw source_.error(rows_[row].id_place,
                        fmt::format("id {} twice, first in line {}", excerpt(rows_[row].id),
                                    source_.at(rows_[first->second].id_place).line),
                        words_.duplicate_why, words_.duplicate_remedy);
  }
  std::vector<std::uint32_t> parents(rows_.size(), no_row);
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    const auto& [id, parent, id_place, parent_place] = rows_[row];
    if (parent.empty()) continue;
    if (id == parent)
      throw source_.error(id_place, fmt::format("node {} is its own parent", excerpt(id)),
                          "a tree has no loops", "correct the parent, or leave it empty for the root");
    const auto found = row_of.find(parent);
    if (found != row_of.end()) {
      parents[row] = found->second;
    } else if (!parents_may_be_missing && !means_none(parent)) {
      throw source_.error(
          parent_place, fmt::format("parent {} of node {} has no row", excerpt(parent), excerpt(id)),
          "every parent is a node itself",
          fmt::format("add its row, or take what lies above node {0} with --root {0}", excerpt(id)));
    }
  }
  return parents;
}

void ParentTable::require_no_cycle(const std::vector<std::uint32_t>& parents) const {
  enum class State : std::uint8_t { unseen, on_path, done };
  std::vector<State> states(parents.size(), State::unseen);
  for (std::uint32_t start = 0; start < parents.size(); ++start) {
    std::uint32_t row = start;
    for (; row != no_row && states[row] == State::unseen; row = parents[row]) states[row] = State::on_path;
    if (row != no_row && states[row] == State::on_path) {
      std::size_t length = 1;
      for (std::uint32_t on = parents[row]; on != row; on = parents[on]) ++length;
      throw source_.error(rows_[row].id_place,
                          fmt::format("a cycle of {} nodes through node {}", length, excerpt(rows_[row].id)),
                          "going from parent to parent must end at a root",
                          "correct the parent of one of them");
    }
    for (row = start; row != no_row && states[row] == State::on_path; row = parents[row])
      states[row] = State::done;
  }
}

std::vector<std::uint32_t> ParentTable::chosen_roots(const std::vector<std::uint32_t>& parents,
                                                     const std::string& root) const {
  std::vector<std::uint32_t> roots;
  if (!root.empty() && root != "all") {
    for (std::uint32_t row = 0; row < rows_.size(); ++row)
      if (rows_[row].id == root) roots.push_back(row);
    if (roots.empty())
      throw Error(fmt::format("{}: --root {}", source_.name(), root), "no node has that id",
                  "give an id of the table");
    return roots;
  }
  for (std::uint32_t row = 0; row < parents.size(); ++row)
    if (parents[row] == no_row) roots.push_back(row);
  if (root.empty() && roots.size() > 1)
    throw source_.error(rows_[roots[1]].id_place,
                        fmt::format("{} roots, among them {} and {}", roots.size(),
                                    excerpt(rows_[roots[0]].id), excerpt(rows_[roots[1]].id)),
                        "a tree has one",
                        fmt::format("take one with --root {}, or each as a tree of its own with --root all",
                                    excerpt(rows_[roots[0]].id)));
  return roots;
}

std::vector<RowTree> ParentTable::trees(const ReadOptions& options) const {
  if (rows_.size() >= no_row)
    throw Error(fmt::format("{}: {} rows", source_.name(), rows_.size()), "at most 4*10^9 fit",
                "cut the table");
  if (rows_.empty())
    throw source_.error(source_.text().size(), "no rows", "a tree has a node at least", "add rows");
  const auto parents = parent_rows(open_ends_ || !options.root.empty());
  require_no_cycle(parents);
  const Children children = children_of(parents);
  std::vector<RowTree> trees;
  for (const std::uint32_t root : chosen_roots(parents, options.root))
    trees.push_back(tree_below(root, children));
  return trees;
}

}  // namespace ramify
