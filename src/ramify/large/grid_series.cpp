#include "ramify/large/grid_series.hpp"

#include <cmath>

namespace ramify {

const std::vector<PlacedSplit>& PlacedRows::row(std::size_t place, std::optional<Residue> residue) {
  Kept& kept = kept_[residue.value_or(residues)];
  const bool follows = kept.place + 1 == place && rows_->is_far(grid_->leaves(kept.place));
  kept.place = place;
  if (follows)
    move_on(kept.splits);
  else
    kept.splits = placed(rows_->row(grid_->leaves(place), residue), place);
  return kept.splits;
}

void PlacedRows::move_on(std::vector<PlacedSplit>& splits) const {
  const double ratio = std::exp(grid_->step());
  for (PlacedSplit& split : splits) {
    ++split.smaller.first;
    ++split.larger.others.first;
    split.smaller_leaves *= ratio;
    split.larger_leaves *= ratio;
  }
}

std::vector<PlacedSplit> PlacedRows::placed(const CompressedRow& row, std::size_t place) const {
  std::vector<PlacedSplit> splits;
  splits.reserve(row.places.size());
  for (const SplitPlace& split : row.places) {
    const double larger_leaves = row.leaves - split.smaller;
    const Stencil smaller = grid_->of_child(place, split.smaller, split.log_smaller);
    const OwnStencil larger = grid_->is_in_table(place, split.log_larger)
                                  ? OwnStencil{grid_->in_table(larger_leaves)}
                                  : grid_->one_sided(place, split.log_larger);
    splits.push_back({smaller, larger, split.weight, split.smaller, larger_leaves, split.smaller_residue,
                      split.larger_residue, split.equal});
  }
  return splits;
}

PerResidue<double> ResidueSystem::solve(std::size_t count) const {
  ResidueSystem left = *this;
  // 1 - own_pp is not_own_p and all other own_pq together; what X_p says is put into the rows above it.
  const auto diagonal = [&left](std::size_t p, std::size_t below) {
    double sum = left.not_own[p];
    for (std::size_t q = 0; q < below; ++q) sum += q == p ? 0 : left.own[p][q];
    return sum;
  };
  for (std::size_t p = count; p-- > 0;) {
    const double rest = diagonal(p, p);
    for (std::size_t r = 0; r < p; ++r) {
      const double share = left.own[r][p] / rest;
      left.known[r] += share * left.known[p];
      left.not_own[r] += share * left.not_own[p];
      for (std::size_t q = 0; q < p; ++q) left.own[r][q] += share * left.own[p][q];
    }
  }
  PerResidue<double> solved{};
  for (std::size_t p = 0; p < count; ++p) {
    double sum = left.known[p];
    for (std::size_t q = 0; q < p; ++q) sum += left.own[p][q] * solved[q];
    solved[p] = sum / diagonal(p, p);
  }
  return solved;
}

}  // namespace ramify
