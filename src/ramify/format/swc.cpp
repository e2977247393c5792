#include "ramify/format/swc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/parent_table.hpp"
#include "ramify/format/point_rows.hpp"
#include "ramify/format/rerooted.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

constexpr double no_length = std::numeric_limits<double>::quiet_NaN();

using detail::Point;

/// What goes into the name of a tree that begins with a point of this type.
std::string_view type_word(int type) {
  switch (type) {
    case Point::soma:
      return ":soma";
    case 2:
      return ":axon";
    case 3:
      return ":dendrite";
    case 4:
      return ":apical";
    default:
      return "";
  }
}

/// A tree of points: the row of every node in preorder, and that of the point which it is joined to.
struct PointTree {
  std::vector<std::uint32_t> arity, rows, joined_to;
};

/// The subtree of a node.
PointTree part(const PointTree& whole, const Tree& tree, std::size_t node) {
  const auto cut = [&](const std::vector<std::uint32_t>& values) {
    const auto begin = values.begin();
    return std::vector(begin + static_cast<std::ptrdiff_t>(node),
                       begin + static_cast<std::ptrdiff_t>(subtree_end(tree, node)));
  };
  return {cut(whole.arity), cut(whole.rows), cut(whole.joined_to)};
}

class Neuron {
 public:
  Neuron(SourceText source, Remarks& remarks)
      : source_(source), points_(detail::read_points(source, remarks)), remarks_(remarks) {}

  std::vector<RecordedTree> trees(const ReadOptions& options) const {
    ParentWords words;
    words.more_roots =
        "each as a tree of its own with --root all, or what leaves the soma with --root neurites";
    ParentTable table(source_, words);
    for (const Point& point : points_) table.add(point.id, point.parent);
    const bool neurites = options.root == "neurites";
    const bool any_root = neurites || options.root.empty() || options.root == "all";
    std::vector<RecordedTree> trees;
    for (const RowTree& found : table.trees(neurites ? ReadOptions{"all", 0} : options, remarks_)) {
      const RowTree rows = any_root ? from_soma(found) : found;
      remark_soma(rows);
      const PointTree points = with_one_soma(rows);
      if (neurites && points_[points.rows.front()].is_soma()) {
        add_children(points, trees);
      } else {
        trees.push_back(recorded(points));
      }
    }
    if (trees.empty())
      throw source_.error(std::size_t{0}, "no neurites", "nothing leaves the soma", "leave out --root");
    if (trees.size() == 1) trees.front().name = source_.name();
    return trees;
  }

 private:
  static constexpr std::uint32_t no_row = UINT32_MAX;

  /// The tree with its soma as the root, wherever that stands in the file.
  RowTree from_soma(const RowTree& tree) const {
    std::size_t first = tree.rows.size(), groups = 0;
    const auto is_soma = [&](std::size_t node) { return points_[tree.rows[node]].is_soma(); };
    if (is_soma(0)) ++groups;
    each_edge(tree.tree, [&](std::size_t parent, std::size_t child) {
      if (!is_soma(child) || is_soma(parent)) return;
      ++groups;
      first = std::min(first, child);
    });
    if (groups > 1)
      remarks_.doubt(fmt::format(
          "{} groups of soma points that are not joined to each other: the first is the root", groups));
    if (groups == 0 || is_soma(0)) return tree;
    remarks_.doubt(fmt::format("the soma, point {}, is the root: the file begins at point {}",
                               points_[tree.rows[first]].id, points_[tree.rows[0]].id));
    return detail::rerooted(tree, first);
  }

  /// Branches that are typed soma are lost in it.
  void remark_soma(const RowTree& tree) const {
    constexpr double many = 2;
    std::size_t soma = 0, far = 0;
    double farthest = 0;
    const Point* first = nullptr;
    for (const std::uint32_t row : tree.rows) {
      const Point& point = points_[row];
      if (!point.is_soma()) continue;
      ++soma;
      if (first == nullptr) first = &point;
      const double radii = detail::distance(point, *first) / first->radius;
      if (!(radii > many) || !std::isfinite(radii)) continue;
      ++far;
      farthest = std::max(farthest, radii);
    }
    if (soma == tree.rows.size() && soma > 1)
      remarks_.doubt(fmt::format("all {} points are typed soma (1): they are one node", soma));
    if (far > 0)
      remarks_.doubt(
          fmt::format("{} up to {:.3g} radii from the first: branches typed soma (1) are lost in it",
                      far == 1 ? "a soma point lies" : fmt::format("{} soma points lie", far), farthest));
  }

  /// A soma point that is joined to another is taken for it, and what is joined to it goes over: preorder
  /// stays as it is.
  PointTree with_one_soma(const RowTree& tree) const {
    std::vector<std::uint32_t> place(tree.rows.size(), 0);
    PointTree points{{tree.tree.arity(0)}, {tree.rows[0]}, {no_row}};
    each_edge(tree.tree, [&](std::size_t parent, std::size_t child) {
      const std::uint32_t row = tree.rows[child];
      if (points_[row].is_soma() && points_[tree.rows[parent]].is_soma()) {
        place[child] = place[parent];
        points.arity[place[parent]] += tree.tree.arity(child);
        --points.arity[place[parent]];
        return;
      }
      place[child] = static_cast<std::uint32_t>(points.arity.size());
      points.arity.push_back(tree.tree.arity(child));
      points.rows.push_back(row);
      points.joined_to.push_back(tree.rows[parent]);
    });
    return points;
  }

  void add_children(const PointTree& points, std::vector<RecordedTree>& trees) const {
    const Tree tree(points.arity);
    for (std::size_t child = 1; child < tree.node_count(); child = subtree_end(tree, child))
      trees.push_back(recorded(part(points, tree, child)));
  }

  RecordedTree recorded(const PointTree& points) const {
    RecordedTree tree;
    for (std::size_t node = 0; node < points.rows.size(); ++node) {
      const Point& point = points_[points.rows[node]];
      const std::uint32_t below = points.joined_to[node];
      tree.lengths.push_back(below == no_row ? no_length : detail::distance(point, points_[below]));
      tree.radii.push_back(point.radius);
      tree.places.push_back({point.x, point.y, point.z});
      tree.names.set(node, point.id);
    }
    tree.tree = Tree(points.arity);
    tree.name =
        fmt::format("{}#{}{}", source_.name(), tree.names[0], type_word(points_[points.rows[0]].type));
    return tree;
  }

  SourceText source_;
  std::vector<Point> points_;
  Remarks& remarks_;
};

}  // namespace

std::vector<RecordedTree> read_swc(SourceText source, const ReadOptions& options, Remarks& remarks) {
  return Neuron(source, remarks).trees(options);
}

}  // namespace ramify
