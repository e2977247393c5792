#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "ramify/model/fixed_split.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Flow-rate tree (A7, after Honda, Tomlinson and Fisher 1981): the split tree of size 2^n with left =
/// floor(n f/2), of which the nodes of depth 1..n are kept. f = 1 splits evenly, a small f leaves one stem.
/// Deterministic.
///
/// K96 2.5.1 prints X = 1/(2f), which is above 1 for f < 1/2 (X20); X = f/2 is what its text describes.
class FlowRate {
 public:
  struct Label {
    Size size;
    Size levels;  ///< from here on, this one counted
  };
  static constexpr std::string_view label_meaning = "internal nodes from it down in the tree that is cut";

  /// @param f  0 < f <= 1. Throws Error.
  explicit FlowRate(double f);

  Label root(Size n) const { return {Size{1} << n, n}; }

  template <class Urbg>
  void children(Label label, Urbg&, std::vector<Label>& below) const {
    if (label.size == 0 || label.levels <= 1) return;
    const Size left = split_.left(label.size);
    below.push_back({left, label.levels - 1});
    below.push_back({label.size - 1 - left, label.levels - 1});
  }

  double expected_nodes(Size n) const { return std::ldexp(1, static_cast<int>(n)); }
  std::size_t largest_order(Size n) const { return n == 0 ? 0 : n - 1; }
  Size largest_size() const { return largest_n; }

  static const ModelInfo& info();

 private:
  static constexpr Size largest_n = 50;

  FixedSplit split_;
};

}  // namespace ramify
