#include "ramify/large/grid_series.hpp"

namespace ramify {

std::vector<PlacedSplit> placed_row(const SizeGrid& grid, const CompressedRows& rows, std::size_t place,
                                    std::optional<Residue> residue) {
  const CompressedRow row = rows.row(grid.leaves(place), residue);
  std::vector<PlacedSplit> placed;
  placed.reserve(row.places.size());
  for (const SplitPlace& split : row.places) {
    const double larger_leaves = row.leaves - split.smaller;
    const Stencil smaller = grid.of_child(place, split.smaller, split.log_smaller);
    const OwnStencil larger = grid.is_in_table(place, split.log_larger)
                                  ? OwnStencil{grid.in_table(larger_leaves)}
                                  : grid.one_sided(place, split.log_larger);
    placed.push_back({smaller, larger, split.weight, split.smaller, larger_leaves, split.smaller_residue,
                      split.larger_residue, split.equal});
  }
  return placed;
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
