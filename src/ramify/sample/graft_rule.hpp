#pragma once

#include <string>

#include "ramify/model/model.hpp"
#include "ramify/sample/sampling_method.hpp"

namespace ramify {

/// What is grafted in the trees of a model: a fixed function of model, method and n, never of the clock or
/// the machine.
///
/// Trees below n = 1024 are grown whole. One statistic: subtrees up to the power of two at or below 8
/// sqrt(n), so that a table costs no more than a few trees, and no further than its law is estimated to take
/// a second and 64 MB (law_cost.hpp): 16384 for the order of a bst. Several at once: up to 16 to 28
/// of orders and height, 12 of orders and paths, where the outcomes are still few (3,000 to 135,000). Mean
/// counts: a 256th of the tree, to 2048, and to 8192 from 2^26 on.
class GraftRule {
 public:
  GraftRule(const Model& model, SamplingMethod method);

  /// Subtrees up to this size are drawn from their exact law in a tree of size n; 0 where every node is
  /// grown.
  Size size(Size n) const;

  /// About as many nodes as are grown for a tree of size n: n, or n over half the graft size to the power
  /// 1-e, where depths grow like n^e (split_character.hpp); for the walk its length.
  double grown_nodes(Size n) const;

  /// "every node is grown", "strahler of subtrees up to n = 16384 drawn from the exact law".
  std::string describe(Size n) const;

 private:
  Model model_;
  SamplingMethod method_;
  Size largest_;  // of a table
  double depth_exponent_;
};

}  // namespace ramify
