#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "ramify/model/model.hpp"

namespace ramify {

/// A number of internal nodes modulo 4, where a law of large trees is not quite smooth in n: ties are there
/// for odd n alone, their two children are even or odd alike, and so on; each further doubling matters less
/// by the weight of a tie.
using Residue = std::uint8_t;
inline constexpr Residue residues = 4;

/// Of a whole number; above 2^53, where no residue matters, of the double.
inline Residue residue_of(double n) {
  return static_cast<Residue>(std::fmod(n, residues));
}

/// One of the splits that stand for all those of a size. Of real numbers of leaves; a weight may be negative
/// (a correction at the end of a panel).
struct SplitPlace {
  double weight;
  double smaller;                  ///< leaves of the smaller child; hardly more than half of all
  double log_smaller, log_larger;  ///< logs of both children's shares of the leaves
  Residue smaller_residue = 0;     ///< of the internal nodes, where the row has a residue
  Residue larger_residue = 0;
  bool equal = false;  ///< a tie: both sizes are the same
};

/// All splits of a number of leaves, up to reflection: a sum over the row of weight times g is that over the
/// n splits of P times g, for every g that is smooth in the log of the sizes.
struct CompressedRow {
  double leaves;
  std::vector<SplitPlace> places;
  double lost;  ///< |sum of the weights - 1| before they were scaled; 0 where the law has no scale of its own
};

/// The rows of a law at sizes of any magnitude, some 100 to 300 places each.
///
/// The first 48 sizes (128) at either end are summed as they are; then Gauss's rule for the counting measure
/// on panels of whole numbers, to a quarter of the leaves or to 2000; then Gauss and Legendre's on panels in
/// the log of the size, with Euler and Maclaurin's term where whole numbers end. Panels follow the law's
/// standard deviation. A binomial row is the trapezoidal rule with half a standard deviation a step, which is
/// exact to rounding.
///
/// A row with a residue (of n) is for laws that tell ties from other splits: it ends at the last smaller
/// child, and its places name the residues of both children.
class CompressedRows {
 public:
  /// What a weight is left out below: an average over the row does not feel 1e-20 of it; the lower tail of a
  /// minimum does, for one small child decides it. Where small children weigh most, as in catalan, all is
  /// kept.
  enum class LeftOut : std::uint8_t { below_1e_20, below_1e_42 };

  /// @param model   a split model with a real_split
  /// @param step    of the grid of sizes, in log leaves: what the law is smooth over
  CompressedRows(const Model& model, double step, double largest_leaves,
                 LeftOut left_out = LeftOut::below_1e_20);

  /// Of 192 leaves or more, with a residue of 512. O(places), some 0.1 us each.
  CompressedRow row(double leaves, std::optional<Residue> residue = std::nullopt) const;

  /// Whether rows of this many leaves and more are the same in shares, to rounding: no place of them is
  /// within the sizes that are summed one by one.
  bool is_far(double leaves) const { return leaves >= far_from_; }

  /// Whether the model has such rows.
  static bool exist(const Model& model);

 private:
  class Builder;
  double panel_width(double log_share) const;
  double far_from(double largest_leaves) const;
  CompressedRow row_in_full(double leaves, std::optional<Residue> residue) const;
  CompressedRow binomial_row(const BinomialSplit& split, double leaves, std::optional<Residue> residue) const;
  void add_whole_panels(Builder& row, double leaves, double last_alone, double whole_below) const;
  void add_panels(Builder& row, double leaves, double bottom, double top) const;

  RealSplit split_;
  double mean_ = 0.5, deviation_ = 1;  ///< of the share of one side; 1 where nothing is concentrated
  double a_ = 1, b_ = 1;               ///< exponents of the share near its ends
  double step_;
  double negligible_;
  double far_from_;
  std::array<CompressedRow, residues + 1> far_;  ///< of each residue, then without one
  std::vector<double> edges_;                    ///< of panels, in the log of the share, from log(1/2) down
};

}  // namespace ramify
