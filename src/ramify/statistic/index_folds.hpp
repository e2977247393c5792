#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "ramify/statistic/b1.hpp"
#include "ramify/statistic/b2.hpp"
#include "ramify/statistic/leaf_depth_variance.hpp"
#include "ramify/statistic/symmetry_nodes.hpp"

namespace ramify {

/// A list of folds that give one number each: f.index(root), root the value at the root.
template <class... Folds>
struct IndexList {
  template <class F>
  static constexpr bool holds = (std::same_as<F, Folds> || ...);

  /// Its place among the numbers of all.
  template <class F>
    requires holds<F>
  static constexpr std::size_t place_of = [] {
    constexpr std::array<bool, sizeof...(Folds)> is_it{std::same_as<F, Folds>...};
    std::size_t place = 0;
    while (!is_it[place]) ++place;
    return place;
  }();

  using Values = std::array<double, sizeof...(Folds)>;
};

/// What is folded for Folded::indices, besides the tolls of toll_sums.hpp.
using IndexFolds = IndexList<B1, B2, LeafDepthVariance, SymmetryNodes>;

}  // namespace ramify
