#pragma once

#include <array>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/large/compressed_rows.hpp"
#include "ramify/large/grid_series.hpp"
#include "ramify/large/size_grid.hpp"
#include "ramify/large/tail_table.hpp"
#include "ramify/law/bounded_law.hpp"

namespace ramify {

/// The law of a statistic with a JoinRule at sizes of any magnitude: the rule on compressed rows, one place
/// of the grid after another.
///
/// With D_k = P(V >= k) of a size and its children, each D_k(z) is a sum over the row of positive products,
/// linear in the D_k of the larger child, of which those within the last steps of the grid refer to D_k(z)
/// itself: 1 minus that part, a sum of positive terms, divides the rest. Upper tails keep their relative
/// accuracy; 1 - D is right in absolute terms. Where a rule tells ties from other splits, every residue of n
/// has laws of its own. Cost: places of the grid x places of a row x values that have a probability, some 0.3
/// us each.
class LargeJoin {
 public:
  /// @param table  of the same model and rule, with the sizes 0..grid.table_size()
  /// Throws Interrupted when cancelled.
  LargeJoin(const JoinRule& rule, const SizeGrid& grid, const CompressedRows& rows, const BoundedLaw& table,
            const Cancellation& cancellation);

  /// P(V >= k), k = 0, 1, ..., of any n on the grid.
  std::vector<double> tail(double n) const;

  /// Of a rule that does not tell ties.
  const TailTable& tails() const { return tails_.front(); }

 private:
  using Values = std::vector<double>;
  /// Of a size and a residue: sums over its row for P(V >= first + i), i = 0, 1, ...
  struct Sums {
    explicit Sums(std::size_t levels);
    Values known;  ///< without what follows
    PerResidue<Values>
        below_own;           ///< coefficient of P(V >= first + i - 1) of the size itself, by its residue
    PerResidue<Values> own;  ///< coefficient of P(V >= first + i)
    Values not_own;          ///< 1 minus the sum of these, of positive terms
  };

  std::size_t classes() const { return tails_.size(); }
  void fill_from(const BoundedLaw& table);
  void extend(std::size_t place, PlacedRows& rows);
  Sums sums(const std::vector<PlacedSplit>& row, std::size_t first, std::size_t levels);
  static void merge(const PlacedSplit& split, std::vector<PlacedSplit>& merged);
  void add_terms(const PlacedSplit& split, Sums& sums) const;
  static Values solve(const std::vector<Sums>& sums, std::size_t level, const std::vector<Values>& solved);

  const JoinRule* rule_;
  const SizeGrid* grid_;
  std::vector<TailTable> tails_;       ///< one, or one of every residue of n
  Values smaller_from_, larger_from_;  // of the children of one split, from first - 1 on
};

}  // namespace ramify
