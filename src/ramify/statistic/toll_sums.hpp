#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ramify/statistic/exact_law.hpp"

namespace ramify {

/// The tolls of all statistics that have one (StatisticInfo::toll).
const std::vector<Toll>& all_tolls();

/// Sums of tolls over the internal nodes of a tree, in the order of all_tolls().
class TollSums {
 public:
  using Value = Size;  ///< external nodes

  TollSums() : tolls_(&all_tolls()), sums_(tolls_->size(), 0.0) {}

  Value external() const { return 1; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& leaves_below) {
    const std::span<const Size> leaves(leaves_below);
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += (*tolls_)[i](leaves);
    Size sum = 0;
    for (const Size below : leaves) sum += below;
    return sum;
  }

  const std::vector<double>& sums() const { return sums_; }

 private:
  const std::vector<Toll>* tolls_;
  std::vector<double> sums_;
};

}  // namespace ramify
