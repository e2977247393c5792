#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/large/grid_series.hpp"
#include "ramify/law/moments.hpp"
#include "ramify/law/node_sum_law.hpp"

namespace ramify {

/// Mean and variance of a sum of tolls over the nodes at sizes of any magnitude: the recurrences of
/// NodeSumLaw on compressed rows, for every residue of n (a toll may tell ties).
///
/// The mean is held over the leaves z, a(z) = E Y/z, and the variance too; between the splits Y/z varies by
/// what a varies from z to the children, taken as differences from a(z). Where that is less than 1e-16 of a
/// it is lost: the variance of a sum whose mean grows like z has an error of 1e-32 z^2. An averaged sum is
/// held as it is. Cost: places of the grid x places of a row, some 0.5 us each.
class LargeNodeSum {
 public:
  /// @param table  of the same model and sum, with the sizes 0..grid.table_size() + residue_reach
  /// Throws Interrupted.
  LargeNodeSum(const NodeSum& sum, const SizeGrid& grid, const CompressedRows& rows, const NodeSumLaw& table,
               const Cancellation& cancellation);

  Moments moments(double n) const;

 private:
  double scale(double leaves) const { return sum_.averaged ? 1 : leaves; }
  /// Of a child of so many leaves, in the scaled recurrence.
  double coefficient(double child, double all) const { return sum_.averaged ? 0.5 : child / all; }
  void extend(std::size_t place, PlacedRows& rows);
  void add_split(const PlacedSplit& split, const GridSeries& series, double of_smaller, double of_larger,
                 Residue p, ResidueSystem& system) const;
  double between_splits(const std::vector<PlacedSplit>& row, std::size_t place, Residue p) const;

  NodeSum sum_;
  const SizeGrid* grid_;
  GridSeries mean_, variance_;
};

}  // namespace ramify
