#include "ramify/tree/resolve_forks.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/tree/each_edge.hpp"

namespace ramify {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The children of every node, one after the other; those of node i from begin[i] to begin[i + 1].
struct ChildLists {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> nodes;
};

ChildLists child_lists(const Tree& tree) {
  ChildLists lists{std::vector<std::size_t>(tree.node_count() + 1, 0), {}};
  for (std::size_t node = 0; node < tree.node_count(); ++node)
    lists.begin[node + 1] = lists.begin[node] + tree.arity(node);
  lists.nodes.resize(lists.begin.back());
  std::vector<std::size_t> next(lists.begin.begin(), lists.begin.end() - 1);
  each_edge(tree, [&](std::size_t parent, std::size_t child) {
    lists.nodes[next[parent]++] = static_cast<std::uint32_t>(child);
  });
  return lists;
}

/// Siblings that are to hang on one node.
struct Group {
  std::size_t begin, end;
};

class Resolver {
 public:
  Resolver(const RecordedTree& tree, ForkResolution resolution, Stream& stream)
      : tree_(tree), resolution_(resolution), stream_(stream), children_(child_lists(tree.tree)) {}

  RecordedTree resolved() {
    out_.name = tree_.name;
    visit(0);
    while (!pending_.empty()) {
      const Group group = pending_.back();
      pending_.pop_back();
      if (group.end - group.begin == 1) {
        visit(children_.nodes[group.begin]);
      } else {
        add(2, 0, unknown);
        split(group);
      }
    }
    out_.tree = Tree(std::move(arity_));
    return std::move(out_);
  }

 private:
  void add(std::uint32_t arity, double length, double radius) {
    arity_.push_back(arity);
    if (!tree_.lengths.empty()) out_.lengths.push_back(length);
    if (!tree_.radii.empty()) out_.radii.push_back(radius);
  }

  void visit(std::size_t node) {
    const Group group{children_.begin[node], children_.begin[node + 1]};
    const std::size_t size = group.end - group.begin;
    out_.names.set(arity_.size(), tree_.names[node]);
    add(static_cast<std::uint32_t>(std::min<std::size_t>(size, 2)),
        tree_.lengths.empty() ? unknown : tree_.lengths[node],
        tree_.radii.empty() ? unknown : tree_.radii[node]);
    if (size == 1) pending_.push_back(group);
    if (size > 2 && resolution_ == ForkResolution::random) shuffle(group);
    if (size > 1) split(group);
  }

  /// The two sides of a node; the left is taken up first.
  void split(Group group) {
    const std::size_t size = group.end - group.begin;
    const std::size_t left =
        resolution_ == ForkResolution::ladder || size == 2 ? 1 : 1 + uniform_below(stream_, size - 1);
    pending_.push_back({group.begin + left, group.end});
    pending_.push_back({group.begin, group.begin + left});
  }

  void shuffle(Group group) {
    for (std::size_t i = group.end - 1; i > group.begin; --i)
      std::swap(children_.nodes[i],
                children_.nodes[group.begin + uniform_below(stream_, i - group.begin + 1)]);
  }

  const RecordedTree& tree_;
  ForkResolution resolution_;
  Stream& stream_;
  ChildLists children_;
  std::vector<Group> pending_;
  std::vector<std::uint32_t> arity_;
  RecordedTree out_;
};

}  // namespace

std::size_t wide_forks(const Tree& tree) {
  return static_cast<std::size_t>(
      std::ranges::count_if(tree.arities(), [](std::uint32_t arity) { return arity > 2; }));
}

RecordedTree resolve_forks(RecordedTree tree, ForkResolution resolution, Stream& stream) {
  if (wide_forks(tree.tree) == 0) return tree;
  return Resolver(tree, resolution, stream).resolved();
}

ForkResolution parse_fork_resolution(const std::string& name) {
  if (name == "ladder") return ForkResolution::ladder;
  if (name == "random") return ForkResolution::random;
  throw Error(fmt::format("--resolve {}", name), "no way to resolve forks", "take ladder or random");
}

}  // namespace ramify
