#pragma once

#include <array>
#include <cstddef>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// How a quantity between two places of a SizeGrid follows from eight of them: the sum over r of weight[r]
/// times its value at first + r.
struct Stencil {
  static constexpr std::size_t width = 8;

  std::size_t first = 0;
  std::array<double, width> weight{};
};

/// A stencil that may reach the size whose law is being computed: that one's part apart.
struct OwnStencil {
  Stencil others;
  double own = 0;      ///< weight of the size itself
  double not_own = 1;  ///< 1 - own, the sum of the other weights, which may be as small as 1/n
};

/// The sizes at which laws of large trees are held: all of 0..table_size, then a geometric grid.
///
/// Place s is size s up to table_size; place table_size + 1 + g is the real number of leaves (external nodes)
/// (table_size + 1) exp((g - lead) step). The first `lead` of these lie within the table again, so that the
/// grid can be interpolated right from the seam on. Between places a quantity is the polynomial of degree 7
/// through eight of them, in whole sizes below the seam and in the log of the number of leaves above.
class SizeGrid {
 public:
  static constexpr std::size_t lead = Stencil::width;

  /// @param table_size  at least 64
  /// @param step        of log leaves, at most log(2)/8: no half of a size reaches the size itself
  /// @param largest     leaves that must be reachable, with room to interpolate there
  SizeGrid(Size table_size, double step, double largest);

  Size table_size() const { return table_size_; }
  double step() const { return step_; }
  std::size_t places() const { return table_size_ + 1 + points_; }

  /// The places of the grid.
  std::size_t first_point() const { return table_size_ + 1; }
  /// The first whose values do not come from the table.
  std::size_t first_new_point() const { return first_point() + lead; }

  /// Leaves of a place.
  double leaves(std::size_t place) const;

  /// Of a real number of leaves within the table.
  Stencil in_table(double leaves) const;

  /// Of leaves(place) exp(log_share), centred. log_share <= 0, the result above the seam or within the lead.
  Stencil centred(std::size_t place, double log_share) const;

  /// Of a child of a place, by its leaves within the table, by its share of leaves(place) above.
  Stencil of_child(std::size_t place, double leaves, double log_share) const {
    return is_in_table(place, log_share) ? in_table(leaves) : centred(place, log_share);
  }

  /// The same as centred, from places up to `place` alone.
  OwnStencil one_sided(std::size_t place, double log_share) const;

  /// Of any number of leaves up to `largest`.
  Stencil anywhere(double leaves) const;

  /// Weights of eight equally spaced nodes at `beyond` of a step from the fourth to the fifth.
  static Stencil between_equal(double beyond);

  /// Whether leaves(place) exp(log_share) lies within the table.
  bool is_in_table(std::size_t place, double log_share) const {
    return position(place) * step_ + log_share <= 0;
  }

 private:
  /// In steps from the seam.
  double position(std::size_t place) const {
    return static_cast<double>(place) - static_cast<double>(first_new_point());
  }

  Size table_size_;
  double step_;
  std::size_t points_;
};

}  // namespace ramify
