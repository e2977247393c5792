#include "support/second_constructions.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "ramify/random/uniform.hpp"

namespace ramify::test {
namespace {

/// Bits of a random string, drawn when they are first looked at; true = left.
class BitString {
 public:
  bool bit(std::size_t i, double p, Stream& stream) {
    while (bits_.size() <= i) bits_.push_back(uniform_open(stream) < p);
    return bits_[i];
  }

 private:
  std::vector<bool> bits_;
};

/// The contracted trie of strings[first..last), which agree in their first `level` bits; the number of its
/// root.
int contract_trie(std::vector<BitString>& strings, std::size_t first, std::size_t last, std::size_t level,
                  double p, Stream& stream, LinkedTree& tree) {
  if (last - first == 1) return -1;
  const auto begin = strings.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = strings.begin() + static_cast<std::ptrdiff_t>(last);
  const auto middle = std::partition(begin, end, [&](BitString& s) { return s.bit(level, p, stream); });
  if (middle == begin || middle == end)
    return contract_trie(strings, first, last, level + 1, p, stream, tree);
  const auto split = static_cast<std::size_t>(middle - strings.begin());
  const int node = static_cast<int>(tree.nodes.size());
  tree.nodes.emplace_back();
  const int left = contract_trie(strings, first, split, level + 1, p, stream, tree);
  const int right = contract_trie(strings, split, last, level + 1, p, stream, tree);
  tree.nodes[static_cast<std::size_t>(node)] = {left, right};
  return node;
}

/// Goes down from the root as goes_left(node, level) says and hangs node `next` into the first free place.
template <class GoesLeft>
void insert(LinkedTree& tree, GoesLeft goes_left) {
  const int added = static_cast<int>(tree.nodes.size());
  int* place = &tree.root;
  for (std::size_t level = 0; *place != -1; ++level) {
    auto& node = tree.nodes[static_cast<std::size_t>(*place)];
    place = goes_left(*place, level) ? &node.left : &node.right;
  }
  *place = added;
  tree.nodes.emplace_back();
}

int grow_by_order_statistics(std::size_t n, std::size_t a, std::size_t b, Stream& stream, LinkedTree& tree) {
  if (n == 0) return -1;
  std::vector<double> uniforms(a + b - 1);
  for (double& u : uniforms) u = uniform_open(stream);
  std::sort(uniforms.begin(), uniforms.end());
  const auto left_size = static_cast<std::size_t>(static_cast<double>(n) * uniforms[a - 1]);
  const int node = static_cast<int>(tree.nodes.size());
  tree.nodes.emplace_back();
  const int left = grow_by_order_statistics(left_size, a, b, stream, tree);
  const int right = grow_by_order_statistics(n - 1 - left_size, a, b, stream, tree);
  tree.nodes[static_cast<std::size_t>(node)] = {left, right};
  return node;
}

/// Segments by number: 0 is the stem, below it those of the nodes' left and right children.
int& segment(LinkedTree& tree, std::size_t number) {
  if (number == 0) return tree.root;
  auto& node = tree.nodes[(number - 1) / 2];
  return number % 2 == 1 ? node.left : node.right;
}

/// Puts a new internal node on a segment, between a new external node on one side and what was there.
void bifurcate(LinkedTree& tree, std::size_t number, bool keeps_left) {
  int& place = segment(tree, number);
  const int below = std::exchange(place, static_cast<int>(tree.nodes.size()));
  tree.nodes.push_back(keeps_left ? LinkedTree::Node{below, -1} : LinkedTree::Node{-1, below});
}

LinkedTree grow_by_segments(std::size_t n, std::size_t first, Stream& stream) {
  LinkedTree tree;
  bifurcate(tree, 0, true);
  while (tree.nodes.size() < n) {
    const std::size_t number = first + uniform_below(stream, 2 * tree.nodes.size() + 1 - first);
    bifurcate(tree, number, uniform_below(stream, 2) == 0);
  }
  return tree;
}

/// A PATRICIA tree under construction: a node knows which bit it looks at; children >= 0 are nodes, others
/// strings: -1 - number.
class StringTree {
 public:
  StringTree(double p, Stream& stream) : p_(p), stream_(stream) {}

  void insert() {
    strings_.emplace_back();
    const std::size_t added = strings_.size() - 1;
    if (added == 0) return;
    const int met = *descend(added, [](const Node&) { return true; });
    const std::size_t other = string_of(met);
    std::size_t level = 0;
    while (bit(added, level) == bit(other, level)) ++level;
    int* place = descend(added, [level](const Node& node) { return node.level < level; });
    const int below = std::exchange(*place, static_cast<int>(nodes_.size()));
    const int leaf = -1 - static_cast<int>(added);
    nodes_.push_back(bit(added, level) ? Node{level, leaf, below} : Node{level, below, leaf});
  }

  LinkedTree shape() const {
    LinkedTree tree;
    const auto number = [](int child) { return std::max(child, -1); };
    for (const Node& node : nodes_) tree.nodes.push_back({number(node.left), number(node.right)});
    tree.root = number(root_);
    return tree;
  }

 private:
  struct Node {
    std::size_t level;
    int left, right;
  };

  static std::size_t string_of(int child) { return static_cast<std::size_t>(-1 - child); }
  bool bit(std::size_t string, std::size_t level) { return strings_[string].bit(level, p_, stream_); }

  /// Where the string's own bits lead, as long as there are nodes and goes_on(node).
  template <class GoesOn>
  int* descend(std::size_t string, GoesOn goes_on) {
    int* place = &root_;
    while (*place >= 0) {
      Node& node = nodes_[static_cast<std::size_t>(*place)];
      if (!goes_on(node)) break;
      place = bit(string, node.level) ? &node.left : &node.right;
    }
    return place;
  }

  double p_;
  Stream& stream_;
  std::vector<BitString> strings_;
  std::vector<Node> nodes_;
  int root_ = -1;  // the first string
};

std::string word_below(const LinkedTree& tree, int node) {
  if (node == -1) return "E";
  const auto& children = tree.nodes[static_cast<std::size_t>(node)];
  return fmt::format("({}{})", word_below(tree, children.left), word_below(tree, children.right));
}

OrderAndHeight look_below(const LinkedTree& tree, int node) {
  if (node == -1) return {0, 1};
  const auto& children = tree.nodes[static_cast<std::size_t>(node)];
  const OrderAndHeight left = look_below(tree, children.left), right = look_below(tree, children.right);
  const std::size_t order = left.order == right.order ? left.order + 1 : std::max(left.order, right.order);
  return {order, 1 + std::max(left.height, right.height)};
}

}  // namespace

LinkedTree bst_by_insertion(std::size_t n, Stream& stream) {
  std::vector<std::size_t> keys(n);
  std::iota(keys.begin(), keys.end(), std::size_t{0});
  for (std::size_t i = n; i > 1; --i) std::swap(keys[i - 1], keys[uniform_below(stream, i)]);
  LinkedTree tree;
  for (const std::size_t key : keys)
    insert(tree, [&](int node, std::size_t) { return key < keys[static_cast<std::size_t>(node)]; });
  return tree;
}

LinkedTree dst_by_insertion(std::size_t n, double p, Stream& stream) {
  LinkedTree tree;
  for (std::size_t i = 0; i < n; ++i) {
    BitString string;
    insert(tree, [&](int, std::size_t level) { return string.bit(level, p, stream); });
  }
  return tree;
}

LinkedTree patricia_of_strings(std::size_t n, double p, Stream& stream) {
  std::vector<BitString> strings(n + 1);
  LinkedTree tree;
  tree.root = contract_trie(strings, 0, n + 1, 0, p, stream, tree);
  return tree;
}

LinkedTree patricia_by_insertion(std::size_t n, double p, Stream& stream) {
  StringTree tree(p, stream);
  for (std::size_t i = 0; i <= n; ++i) tree.insert();
  return tree.shape();
}

LinkedTree terminal_growth(std::size_t n, Stream& stream) {
  LinkedTree tree;
  while (tree.nodes.size() < n) {
    const std::size_t number = uniform_below(stream, 2 * tree.nodes.size() + 1);
    if (segment(tree, number) == -1) bifurcate(tree, number, true);
  }
  return tree;
}

LinkedTree segmental_growth(std::size_t n, Stream& stream) {
  return grow_by_segments(n, 0, stream);
}

LinkedTree stemless_segmental_growth(std::size_t n, Stream& stream) {
  return grow_by_segments(n, 1, stream);
}

LinkedTree ford_by_growth(std::size_t n, double weight, Stream& stream) {
  LinkedTree tree;
  bifurcate(tree, 0, true);
  while (tree.nodes.size() < n) {
    const double inner = static_cast<double>(tree.nodes.size()), leaves = inner + 1;
    const double all = (1 - weight) * leaves + weight * inner;
    const bool at_leaf = uniform_open(stream) * all < (1 - weight) * leaves;
    std::size_t number = 0;
    do number = uniform_below(stream, 2 * tree.nodes.size() + 1);
    while ((segment(tree, number) == -1) != at_leaf);
    bifurcate(tree, number, uniform_below(stream, 2) == 0);
  }
  return tree;
}

LinkedTree catalan_by_remy(std::size_t n, Stream& stream) {
  // Knuth's algorithm R (TAOCP 4A, 7.2.1.6): L[0] is the root; odd numbers are internal nodes, even ones
  // external.
  std::vector<std::size_t> links(2 * n + 1, 0);
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t x = uniform_below(stream, 4 * k - 2);
    const std::size_t side = x % 2, chosen = x / 2;
    links[2 * k - side] = 2 * k;
    links[2 * k - 1 + side] = links[chosen];
    links[chosen] = 2 * k - 1;
  }
  const auto number = [](std::size_t link) { return link % 2 == 1 ? static_cast<int>(link / 2) : -1; };
  LinkedTree tree;
  tree.root = number(links[0]);
  for (std::size_t i = 0; i < n; ++i)
    tree.nodes.push_back({number(links[2 * i + 1]), number(links[2 * i + 2])});
  return tree;
}

LinkedTree beta_by_order_statistics(std::size_t n, std::size_t a, std::size_t b, Stream& stream) {
  LinkedTree tree;
  tree.root = grow_by_order_statistics(n, a, b, stream, tree);
  return tree;
}

LinkedTree beta_multinomial_by_insertion(std::size_t n, double a, double b, Stream& stream) {
  LinkedTree tree;
  struct Gone {
    double left = 0, right = 0;
  };
  std::vector<Gone> gone(n);
  for (std::size_t i = 0; i < n; ++i)
    insert(tree, [&](int node, std::size_t) {
      auto& [left, right] = gone[static_cast<std::size_t>(node)];
      const bool goes_left = uniform_open(stream) * (left + right + a + b) < left + a;
      ++(goes_left ? left : right);
      return goes_left;
    });
  return tree;
}

OrderAndHeight order_and_height(const LinkedTree& tree) {
  return look_below(tree, tree.root);
}

std::string to_word(const LinkedTree& tree) {
  return word_below(tree, tree.root);
}

}  // namespace ramify::test
