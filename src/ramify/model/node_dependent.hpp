#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "ramify/model/beta.hpp"
#include "ramify/model/dst.hpp"
#include "ramify/model/fixed_split.hpp"
#include "ramify/model/formula.hpp"
#include "ramify/model/split_law.hpp"
#include "ramify/model/ternary.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/tree/largest_order.hpp"

namespace ramify {

// The laws whose parameters may depend on the node: what they are called and how many children a node has.

struct NodeBeta {
  using Law = Beta;
  static constexpr Size children = 2;
  static const ModelInfo& info();
};

struct NodeSplit {
  using Law = FixedSplit;
  static constexpr Size children = 2;
  static const ModelInfo& info();
};

struct NodeDst {
  using Law = Dst;
  static constexpr Size children = 2;
  static const ModelInfo& info();
};

struct NodeTernary {
  using Law = Ternary;
  static constexpr Size children = 3;
  static const ModelInfo& info();
};

/// Formulas of the texts, one for each parameter of the model. Throws Error where a text is none.
std::vector<Formula> read_formulas(const ModelInfo& info, std::span<const std::string> texts);

/// The value of the i-th formula at a node. Throws Error where it is out of the parameter's domain.
double value_at(const ModelInfo& info, std::vector<Formula>& formulas, std::size_t i, const NodePlace& node);

/// Places at which formulas are tried out for trees of size n: depths and sizes in steps of 1 up to 8 and
/// then of a quarter, as far as nodes of a tree of size n can have them, size 2 at least.
std::vector<NodePlace> trial_places(Size n);

/// A split tree whose law depends on the node (A10, A24): its parameters are formulas of depth, size and n.
/// Kruszewski 1996, 2.5.5, 3.3.4.
///
/// node_beta(A,B): left = floor(size X), X ~ beta(A,B); node_split(X): left = floor(size X); node_dst(P):
/// left ~ Bin(size-1, P); node_ternary(P): Ternary with p = P. A node of size 1 leaves no choice, and no
/// formula is asked. Use one object for one thread at a time.
template <class Kind>
class NodeDependent {
 public:
  using Label = NodePlace;
  static constexpr std::string_view label_meaning = "internal nodes from it down";

  /// Throws Error where a text is no formula. @param texts  one for each parameter
  explicit NodeDependent(std::span<const std::string> texts)
      : formulas_(read_formulas(Kind::info(), texts)) {}

  Label root(Size n) const { return {n, 1, n}; }

  /// Throws Error where a formula leaves its domain.
  template <class Urbg>
  void children(const Label& node, Urbg& stream, std::vector<Label>& below) {
    if (node.size == 0) return;
    sizes_.clear();
    if (node.size == 1)
      sizes_.assign(Kind::children, 0);
    else
      split(law_at(node), node.size, stream);
    for (const Size size : sizes_) below.push_back({size, node.depth + 1, node.n});
  }

  /// Throws Error where a formula leaves its domain at one of trial_places(n).
  void require_size(Size n) {
    for (const NodePlace& node : trial_places(n)) law_at(node);
  }

  double expected_nodes(Size n) const { return Kind::children * static_cast<double>(n) + 1; }
  std::size_t largest_order(Size n) const { return largest_strahler_order((Kind::children - 1) * n + 1); }
  Size largest_size() const { return max_double_size; }
  std::uint64_t content_hash() const {
    std::string texts;
    for (const Formula& formula : formulas_) texts += formula.text() + ",";
    std::erase(texts, ' ');
    return hash_text(texts);
  }

 private:
  typename Kind::Law law_at(const NodePlace& node) {
    const ModelInfo& info = Kind::info();
    const double first = value_at(info, formulas_, 0, node);
    if constexpr (std::is_constructible_v<typename Kind::Law, double, double>) {
      return {first, value_at(info, formulas_, 1, node)};
    } else {
      return typename Kind::Law(first);
    }
  }

  template <class Law, class Urbg>
  void split(const Law& law, Size size, Urbg& stream) {
    if constexpr (Kind::children == 2) {
      const Size left = law.left(size, stream);
      sizes_.assign({left, size - 1 - left});
    } else {
      law.children(size, stream, sizes_);
    }
  }

  std::vector<Formula> formulas_;
  std::vector<Size> sizes_;  // of the children of the node at hand
};

}  // namespace ramify
