#include "ramify/format/swc.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/parent_table.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Point {
  std::string_view id, parent;
  double x, y, z, radius;
  std::string_view type;
  bool is_soma() const { return type == "1"; }
};

/// What goes into the name of a tree that begins with a point of this type.
std::string_view type_word(std::string_view type) {
  if (type == "1") return ":soma";
  if (type == "2") return ":axon";
  if (type == "3") return ":dendrite";
  return type == "4" ? ":apical" : "";
}

std::string_view plain_id(const SourceText& source, std::string_view field) {
  const std::string_view digits = field.substr(field.starts_with('-') ? 1 : 0);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos)
    throw source.error(field, fmt::format("id '{}'", excerpt(field)), "ids are whole numbers",
                       "write the seven columns id type x y z radius parent");
  return field;
}

Point point_of(const SourceText& source, const std::vector<std::string_view>& fields) {
  if (fields.size() < 7)
    throw source.error(fields.back(), fmt::format("a line of {} field(s)", fields.size()),
                       "a point has seven: id type x y z radius parent",
                       "restore what was cut off, or put # before a comment");
  const double radius = number_in(source, fields[5], "radius");
  if (radius < 0)
    throw source.error(fields[5], fmt::format("radius {}", fields[5]), "it is not negative", "correct it");
  const std::string_view parent = plain_id(source, fields[6]);
  return {plain_id(source, fields[0]),
          parent == "-1" ? parent.substr(0, 0) : parent,
          number_in(source, fields[2], "x"),
          number_in(source, fields[3], "y"),
          number_in(source, fields[4], "z"),
          radius,
          fields[1]};
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
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
  explicit Neuron(SourceText source) : source_(source) {
    DelimitedRows rows(source);
    while (rows.next()) points_.push_back(point_of(source, rows.fields()));
  }

  std::vector<RecordedTree> trees(const ReadOptions& options) const {
    ParentTable table(source_);
    for (const Point& point : points_) table.add(point.id, point.parent);
    const bool neurites = options.root == "neurites";
    std::vector<RecordedTree> trees;
    for (const RowTree& rows : table.trees(neurites ? ReadOptions{"all", 0} : options)) {
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
      tree.lengths.push_back(below == no_row ? none : distance(point, points_[below]));
      tree.radii.push_back(point.radius);
      tree.names.set(node, point.id);
    }
    tree.tree = Tree(points.arity);
    tree.name =
        fmt::format("{}#{}{}", source_.name(), tree.names[0], type_word(points_[points.rows[0]].type));
    return tree;
  }

  SourceText source_;
  std::vector<Point> points_;
};

/// x of every node: the middle of the leaves below it.
std::vector<double> middles(const Tree& tree, const std::vector<Size>& leaves) {
  std::vector<double> x(tree.node_count());
  double left = 0;  // leaves before the node, in preorder
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    x[node] = left + static_cast<double>(leaves[node] - 1) / 2;
    if (tree.arity(node) == 0) ++left;
  }
  return x;
}

std::vector<Size> leaves_below(const Tree& tree, const std::vector<std::size_t>& parents) {
  std::vector<Size> leaves(tree.node_count(), 0);
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    if (tree.arity(node) == 0) leaves[node] = 1;
    if (node > 0) leaves[parents[node]] += leaves[node];
  }
  return leaves;
}

void append_points(std::string& text, const Tree& tree, std::size_t first_id) {
  std::vector<std::size_t> parents(tree.node_count(), 0), depths(tree.node_count(), 0);
  each_edge(tree, [&](std::size_t parent, std::size_t child) {
    parents[child] = parent;
    depths[child] = depths[parent] + 1;
  });
  const auto leaves = leaves_below(tree, parents);
  const auto x = middles(tree, leaves);
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    const std::string parent = node == 0 ? "-1" : std::to_string(first_id + parents[node]);
    text += fmt::format("{} {} {} {} 0 {:.4g} {}\n", first_id + node, node == 0 ? 1 : 3, x[node],
                        depths[node], 0.1 * std::cbrt(static_cast<double>(leaves[node])), parent);
  }
}

}  // namespace

std::vector<RecordedTree> read_swc(SourceText source, const ReadOptions& options) {
  return Neuron(source).trees(options);
}

std::string write_swc(const std::vector<RecordedTree>& trees) {
  std::string text = "# id type x y z radius parent\n";
  std::size_t first_id = 1;
  for (const RecordedTree& tree : trees) {
    append_points(text, tree.tree, first_id);
    first_id += tree.tree.node_count();
  }
  return text;
}

}  // namespace ramify
