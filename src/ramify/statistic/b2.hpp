#pragma once

#include <cmath>
#include <numeric>
#include <span>

#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// B2 (Shao and Sokal 1990): the entropy, in bits, of the external node that a walk from the root reaches
/// when it turns to every child alike. Of a node with k children log2(k) and the mean of those of its
/// children.
class B2 {
 public:
  using Value = double;

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& entropies) const {
    const auto children = static_cast<double>(entropies.size());
    return std::log2(children) + std::accumulate(entropies.begin(), entropies.end(), 0.0) / children;
  }

  double index(Value root) const { return root; }

  static double toll(std::span<const double> leaves) { return std::log2(static_cast<double>(leaves.size())); }
  static constexpr NodeSum recurrence{toll, true};
};

}  // namespace ramify
