#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ramify/large/compressed_rows.hpp"
#include "ramify/large/size_grid.hpp"

namespace ramify {

/// Of every residue of n modulo 4.
template <class T>
using PerResidue = std::array<T, residues>;

/// What sizes of one residue have at a size n of another: the polynomial through eight of them around n.
/// @param at  value of a size; n >= residue_reach
inline constexpr Size residue_reach = 16;
template <class At>
double between_residues(Size n, Residue residue, At at) {
  const Size up = (residues + residue - n % residues) % residues;
  const Stencil stencil = SizeGrid::between_equal(static_cast<double>(residues - up) / residues);
  double sum = 0;
  for (Size r = 0; r < Stencil::width; ++r)
    sum += stencil.weight[r] * at(n + up + residues * r - residues * Stencil::width / 2);
  return sum;
}

/// A quantity at the places of a grid, of every residue of n.
class GridSeries {
 public:
  /// @param at  the quantity at the sizes 0..grid.table_size() + residue_reach
  template <class At>
  GridSeries(const SizeGrid& grid, At at) {
    for (Residue q = 0; q < residues; ++q) {
      values_[q].resize(grid.places());
      for (Size n = 0; n <= grid.table_size(); ++n)
        values_[q][n] = n % residues == q || n < residue_reach ? at(n) : between_residues(n, q, at);
      for (std::size_t place = grid.first_point(); place < grid.first_new_point(); ++place)
        values_[q][place] = this->at(grid.in_table(grid.leaves(place)), q);
    }
  }

  double& operator()(std::size_t place, Residue q) { return values_[q][place]; }
  double operator()(std::size_t place, Residue q) const { return values_[q][place]; }

  double at(const Stencil& stencil, Residue q) const {
    double sum = 0;
    for (std::size_t r = 0; r < Stencil::width; ++r) sum += stencil.weight[r] * values_[q][stencil.first + r];
    return sum;
  }

  /// The weighted values there, each minus `base`: differences, so that a slow series keeps its digits.
  double above(const Stencil& stencil, Residue q, double base) const {
    double sum = 0;
    for (std::size_t r = 0; r < Stencil::width; ++r)
      if (stencil.weight[r] != 0) sum += stencil.weight[r] * (values_[q][stencil.first + r] - base);
    return sum;
  }

 private:
  PerResidue<std::vector<double>> values_;
};

/// One of a row's splits at a place of the grid: where its children are read.
struct PlacedSplit {
  Stencil smaller;
  OwnStencil larger;
  double weight;
  double smaller_leaves, larger_leaves;
  Residue smaller_residue, larger_residue;
  bool equal;
};

/// The rows of one place after another, their children found on the grid. Of far rows, which are the same in
/// shares, the row of the place before is moved on.
class PlacedRows {
 public:
  PlacedRows(const SizeGrid& grid, const CompressedRows& rows) : grid_(&grid), rows_(&rows) {}

  /// Valid until the next row of the same residue is asked for.
  const std::vector<PlacedSplit>& row(std::size_t place, std::optional<Residue> residue = std::nullopt);

 private:
  struct Kept {
    std::size_t place = 0;
    std::vector<PlacedSplit> splits;
  };
  std::vector<PlacedSplit> placed(const CompressedRow& row, std::size_t place) const;
  void move_on(std::vector<PlacedSplit>& splits) const;

  const SizeGrid* grid_;
  const CompressedRows* rows_;
  std::array<Kept, residues + 1> kept_;  ///< of each residue, then without one
};

/// The X_p of a size, of all residues p or of one alone, from X_p = known_p + sum over q of own_pq X_q, 0 <=
/// own.
struct ResidueSystem {
  PerResidue<double> known{};
  PerResidue<PerResidue<double>> own{};
  PerResidue<double>
      not_own{};  ///< 1 - sum over q of own_pq, summed from positive terms: may be as small as 1/n

  /// Of the first `count`. Elimination without a subtraction (Grassmann, Taksar and Heyman 1985).
  PerResidue<double> solve(std::size_t count) const;
};

}  // namespace ramify
