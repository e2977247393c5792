#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/variates.hpp"
#include "ramify/tree/grammar.hpp"
#include "ramify/tree/largest_order.hpp"

namespace ramify {

/// The trie of n random bit strings (A12): a node with m >= 2 strings below it has those that go left as one
/// child and the others as the other, K ~ Bin(m,p) of them left; a side without strings has no child, so
/// there are one-child nodes. A node with one string is external. Kruszewski 1996, B.1.1. Contracting the
/// one-child nodes makes it patricia(p).
class Trie {
 public:
  using Label = Size;
  static constexpr std::string_view label_meaning = "strings below";

  /// @param p  probability of left, 0 < p < 1. Throws Error.
  explicit Trie(double p);

  Label root(Size n) const { return n; }

  template <class Urbg>
  void children(Label strings, Urbg& stream, std::vector<Label>& below) const {
    if (strings < 2) return;
    const Size left = binomial_variate(stream, strings, p_);
    if (left > 0) below.push_back(left);
    if (left < strings) below.push_back(strings - left);
  }

  /// n external nodes and about n/h internal ones, h the entropy of p (Knuth, TAOCP 6.3).
  double expected_nodes(Size n) const {
    const double entropy = -p_ * std::log(p_) - (1 - p_) * std::log1p(-p_);
    return static_cast<double>(n) * (1 + 1 / entropy);
  }

  std::size_t largest_order(Size n) const { return largest_strahler_order(n); }
  Size largest_size() const { return max_double_size; }

  static const ModelInfo& info();

 private:
  double p_;
};

}  // namespace ramify
