#include "ramify/format/edge_table.hpp"

#include <algorithm>

#include "ramify/core/number.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

/// Which columns there are: those that any tree has.
struct Columns {
  bool tree, length, radius, name;
};

std::string quoted(std::string_view name) {
  if (name.find_first_of(",;\t\"# ") == std::string_view::npos) return std::string(name);
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"') text += '"';
    text += c;
  }
  return text += '"';
}

void append_number(std::string& text, const std::vector<double>& values, std::size_t node) {
  text += ',';
  if (!values.empty() && values[node] == values[node]) text += format_exact(values[node]);
}

void append_rows(std::string& text, const RecordedTree& tree, std::size_t number, const Columns& columns) {
  const auto parents = parent_numbers(tree.tree);
  for (std::size_t node = 0; node < parents.size(); ++node) {
    if (columns.tree) text += std::to_string(number) + ',';
    text += std::to_string(node + 1) + ',' + std::to_string(parents[node]);
    if (columns.length) append_number(text, tree.lengths, node);
    if (columns.radius) append_number(text, tree.radii, node);
    if (columns.name) text += ',' + quoted(tree.names[node]);
    text += '\n';
  }
}

}  // namespace

std::string write_edge_table(const std::vector<RecordedTree>& trees) {
  const auto any = [&](auto has) { return std::ranges::any_of(trees, has); };
  const Columns columns{trees.size() > 1, any([](const auto& tree) { return !tree.lengths.empty(); }),
                        any([](const auto& tree) { return !tree.radii.empty(); }),
                        any([](const auto& tree) { return !tree.names.empty(); })};
  std::string text = columns.tree ? "tree,id,parent" : "id,parent";
  if (columns.length) text += ",length";
  if (columns.radius) text += ",radius";
  if (columns.name) text += ",name";
  text += '\n';
  for (std::size_t i = 0; i < trees.size(); ++i) append_rows(text, trees[i], i + 1, columns);
  return text;
}

}  // namespace ramify
