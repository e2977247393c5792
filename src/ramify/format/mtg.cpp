#include "ramify/format/mtg.hpp"

#include <cmath>
#include <deque>

#include <fmt/format.h>

#include "ramify/format/mtg_graph.hpp"
#include "ramify/format/parent_table.hpp"

namespace ramify {
namespace {

using detail::MtgGraph;

double length_of(const MtgGraph::Vertex& vertex, const MtgGraph::Vertex* parent) {
  if (!std::isnan(vertex.length) || parent == nullptr) return vertex.length;
  return std::hypot(vertex.x - parent->x, vertex.y - parent->y, vertex.z - parent->z);
}

void clear_if_unknown(std::vector<double>& values) {
  for (const double value : values)
    if (!std::isnan(value)) return;
  values.clear();
}

/// The vertices that are nodes at a scale, as a table of parents.
class MtgTrees {
 public:
  MtgTrees(SourceText source, const MtgGraph& graph, unsigned scale)
      : source_(source), graph_(graph), table_(source) {
    const auto& vertices = graph.vertices();
    for (std::uint32_t v = 0; v < vertices.size(); ++v) ids_.push_back(std::to_string(v + 1));
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
      if (!graph.is_node(v, scale)) continue;
      const std::uint32_t parent = graph.parent(v, scale);
      table_.add(ids_[v], parent == MtgGraph::none ? std::string_view() : std::string_view(ids_[parent]),
                 source.offset(vertices[v].label));
      nodes_.push_back(v);
      parents_.push_back(parent);
    }
    if (nodes_.empty())
      throw source.error(source.text().size(), fmt::format("no vertex of scale {}", scale),
                         "there is nothing to make a tree of", "take another --scale");
  }

  std::vector<RecordedTree> trees(const ReadOptions& options, Remarks& remarks) const {
    std::vector<RecordedTree> trees;
    for (const RowTree& rows : table_.trees(options, remarks)) trees.push_back(recorded(rows));
    if (trees.size() == 1) trees.front().name = source_.name();
    return trees;
  }

 private:
  RecordedTree recorded(const RowTree& rows) const {
    RecordedTree tree;
    tree.tree = rows.tree;
    tree.name = fmt::format("{}#{}", source_.name(), table_.id(rows.rows.front()));
    for (std::size_t node = 0; node < rows.rows.size(); ++node) {
      const std::uint32_t row = rows.rows[node];
      const auto& vertices = graph_.vertices();
      const MtgGraph::Vertex& vertex = vertices[nodes_[row]];
      tree.lengths.push_back(
          length_of(vertex, parents_[row] == MtgGraph::none ? nullptr : &vertices[parents_[row]]));
      tree.radii.push_back(vertex.radius);
      tree.names.set(node, vertex.label);
    }
    clear_if_unknown(tree.lengths);
    clear_if_unknown(tree.radii);
    return tree;
  }

  SourceText source_;
  const MtgGraph& graph_;
  ParentTable table_;
  std::deque<std::string> ids_;
  std::vector<std::uint32_t> nodes_, parents_;  // of every row: its vertex, and its parent's
};

NumberStyle style_of_features(const detail::MtgHeader& header, LineCursor lines) {
  NumberStyle style(false);
  while (lines.next()) {
    const auto fields = detail::mtg_fields(lines.line());
    for (const auto& column : {header.length, header.radius, header.diameter, header.x, header.y, header.z})
      if (column && *column < fields.size()) style.see(fields[*column]);
  }
  return style;
}

}  // namespace

std::vector<RecordedTree> read_mtg(SourceText source, const ReadOptions& options, Remarks& remarks) {
  LineCursor lines(source.text());
  const detail::MtgHeader header = detail::read_mtg_header(source, lines);
  MtgGraph graph(source, header, style_of_features(header, lines), remarks);
  while (lines.next()) graph.add_line(lines.line());
  graph.require_whole_scene();
  for (const std::string_view feature : header.ignored) remarks.ignore_named("feature", feature);
  return MtgTrees(source, graph, options.scale).trees(options, remarks);
}

}  // namespace ramify
