#include "ramify/large/large_node_sum.hpp"

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

double toll_of(const NodeSum& sum, const PlacedSplit& split) {
  return sum.toll(std::array{split.smaller_leaves, split.larger_leaves});
}

}  // namespace

LargeNodeSum::LargeNodeSum(const NodeSum& sum, const SizeGrid& grid, const CompressedRows& rows,
                           const NodeSumLaw& table, const Cancellation& cancellation)
    : sum_(sum),
      grid_(&grid),
      mean_(grid, [&](Size n) { return table.moments(n).mean / scale(static_cast<double>(n + 1)); }),
      variance_(grid, [&](Size n) { return table.moments(n).variance / scale(static_cast<double>(n + 1)); }) {
  PlacedRows placed(grid, rows);
  for (std::size_t place = grid.first_new_point(); place < grid.places(); ++place) {
    if (cancellation.requested()) throw Interrupted();
    extend(place, placed);
  }
}

void LargeNodeSum::extend(std::size_t place, PlacedRows& rows) {
  const double leaves = grid_->leaves(place);
  PerResidue<const std::vector<PlacedSplit>*> row{};
  for (Residue p = 0; p < residues; ++p) row[p] = &rows.row(place, p);
  ResidueSystem mean, variance;
  for (Residue p = 0; p < residues; ++p)
    for (const PlacedSplit& split : *row[p]) {
      add_split(split, mean_, coefficient(split.smaller_leaves, leaves),
                coefficient(split.larger_leaves, leaves), p, mean);
      mean.known[p] += split.weight * toll_of(sum_, split) / scale(leaves);
    }
  const auto means = mean.solve(residues);
  for (Residue p = 0; p < residues; ++p) mean_(place, p) = means[p];
  // Var Y / z of a child counts (child/z) times its own; of an average 1/4.
  for (Residue p = 0; p < residues; ++p) {
    for (const PlacedSplit& split : *row[p]) {
      const double smaller = coefficient(split.smaller_leaves, leaves),
                   larger = coefficient(split.larger_leaves, leaves);
      const double share = sum_.averaged ? 0.5 : 1;
      add_split(split, variance_, share * smaller, share * larger, p, variance);
    }
    variance.known[p] += scale(leaves) * between_splits(*row[p], place, p);
  }
  const auto variances = variance.solve(residues);
  for (Residue p = 0; p < residues; ++p) variance_(place, p) = variances[p];
}

void LargeNodeSum::add_split(const PlacedSplit& split, const GridSeries& series, double of_smaller,
                             double of_larger, Residue p, ResidueSystem& system) const {
  system.known[p] += split.weight * (of_smaller * series.at(split.smaller, split.smaller_residue) +
                                     of_larger * series.at(split.larger.others, split.larger_residue));
  system.own[p][split.larger_residue] += split.weight * of_larger * split.larger.own;
  // 1 - of_larger own; of a sum 1 - of_larger is of_smaller.
  const double rest = sum_.averaged ? 1 - of_larger : of_smaller;
  system.not_own[p] += split.weight * (split.larger.not_own + split.larger.own * rest);
}

/// The variance over the splits of the scaled mean given the split.
double LargeNodeSum::between_splits(const std::vector<PlacedSplit>& row, std::size_t place, Residue p) const {
  const double leaves = grid_->leaves(place), mean = mean_(place, p);
  double sum = 0;
  for (const PlacedSplit& split : row) {
    const double larger = mean_.above(split.larger.others, split.larger_residue, mean) +
                          split.larger.own * (mean_(place, split.larger_residue) - mean);
    const double deviation =
        coefficient(split.smaller_leaves, leaves) * mean_.above(split.smaller, split.smaller_residue, mean) +
        coefficient(split.larger_leaves, leaves) * larger + toll_of(sum_, split) / scale(leaves);
    sum += split.weight * deviation * deviation;
  }
  return sum;
}

Moments LargeNodeSum::moments(double n) const {
  const double leaves = n + 1;
  const Stencil stencil = grid_->anywhere(leaves);
  const Residue q = residue_of(n);
  return {scale(leaves) * mean_.at(stencil, q), scale(leaves) * variance_.at(stencil, q)};
}

}  // namespace ramify
