#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "ramify/law/bounded_law.hpp"
#include "ramify/law/depth_law.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/node_sum_law.hpp"

namespace ramify {

/// P(X = first + i), i = 0, 1, ...
struct FiniteLaw {
  double first;
  std::vector<double> probabilities;

  /// @param map  a shift alone: values stay one apart
  FiniteLaw mapped(AffineMap map) const;
};

/// The law of size n of a computation that has whole laws.
template <class Law>
FiniteLaw finite_law(const Law& law, Size n) {
  return {static_cast<double>(law.lowest(n)), law.pmf(n)};
}

/// What a recurrence of one value gives, size by size: its law, or the moments of a sum. The one place where
/// a recurrence becomes a computation; counts of orders, which are computed together, are left to
/// OrderMeans and OrderMoments.
class StatisticLaw {
 public:
  /// Room for the sizes 0..largest_n; at first only size 0 is known.
  /// @param recurrence  a join, a path, a walk or a sum
  StatisticLaw(const Recurrence& recurrence, Size largest_n);

  Size sizes() const;

  /// Adds the size row.n == sizes() <= largest_n.
  void extend(const SplitRow& row);

  /// Of a size n < sizes().
  Moments moments(Size n) const;

  /// Nothing of a sum.
  std::optional<FiniteLaw> law(Size n) const;

 private:
  using Computation = std::variant<BoundedLaw, HeightLaw, DepthLaw, NodeSumLaw>;
  static Computation computation(const Recurrence& recurrence, Size largest_n);

  Computation computation_;
};

}  // namespace ramify
