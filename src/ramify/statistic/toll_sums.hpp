#pragma once

#include <cstddef>
#include <iterator>
#include <numeric>
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
    leaves_.assign(std::begin(leaves_below), std::end(leaves_below));
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += (*tolls_)[i](leaves_);
    return std::accumulate(std::begin(leaves_below), std::end(leaves_below), Size{0});
  }

  const std::vector<double>& sums() const { return sums_; }

 private:
  const std::vector<Toll>* tolls_;
  std::vector<double> sums_;
  std::vector<double> leaves_;  // of one node's children, kept for its memory
};

}  // namespace ramify
