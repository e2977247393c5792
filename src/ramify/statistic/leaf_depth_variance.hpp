#pragma once

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Variance of the depths of all external nodes, divisor their number. Mean and sum of squares about it are
/// merged from child to child (Chan, Golub and LeVeque 1983): nothing cancels.
class LeafDepthVariance {
 public:
  struct Value {
    Size leaves;
    double mean;     ///< of the depths, in edges from the node
    double squares;  ///< sum of (depth - mean)^2
  };

  Value external() const { return {1, 0, 0}; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& below) const {
    Value all = below[0];
    for (std::size_t i = 1; i < below.size(); ++i) all = merged(all, below[i]);
    all.mean += 1;
    return all;
  }

  double index(const Value& root) const { return root.squares / static_cast<double>(root.leaves); }

 private:
  static Value merged(const Value& a, const Value& b) {
    const double share = static_cast<double>(b.leaves) / static_cast<double>(a.leaves + b.leaves);
    const double apart = b.mean - a.mean;
    return {a.leaves + b.leaves, a.mean + apart * share,
            a.squares + b.squares + apart * apart * share * static_cast<double>(a.leaves)};
  }
};

}  // namespace ramify
