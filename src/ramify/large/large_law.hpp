#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/large/large_reach.hpp"
#include "ramify/large/refined.hpp"
#include "ramify/law/statistic_law.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// Mean and variance at one size, with their errors.
struct LargeMoments {
  Approximation mean, variance;

  LargeMoments mapped(AffineMap map) const;
};

/// P(X = first + i), i = 0, 1, ..., with their errors.
struct LargeFiniteLaw {
  double first;
  std::vector<Approximation> probabilities;

  /// @param map  a shift alone: values stay one apart
  LargeFiniteLaw mapped(AffineMap map) const;
};

/// The law of one statistic of a split model at sizes from 4096 to 1e300: exact to 2048, then on a geometric
/// grid of sizes (docs/theory/laws-at-every-size.md).
///
/// Every number comes with its error (Refined); the grid is made finer until errors are below 1e-8 of max(1,
/// value), if it can be. Cost: some 0.2 s for an order to 1e9, 1 s for a height.
class LargeLaw {
 public:
  /// Throws Error where the model has no weights at real sizes, and Interrupted.
  /// @param recurrence  a join, a path, a walk or a sum
  /// @param sizes       those that are asked for, at most largest_law_size
  LargeLaw(const Model& model, const Recurrence& recurrence, const std::vector<double>& sizes,
           const Cancellation& cancellation = {});
  LargeLaw(const LargeLaw&) = delete;
  LargeLaw(LargeLaw&&) noexcept;
  LargeLaw& operator=(const LargeLaw&) = delete;
  LargeLaw& operator=(LargeLaw&&) noexcept;
  ~LargeLaw();

  /// Of an n from large_law_table(model) on, at most the largest of the sizes.
  LargeMoments moments(double n) const;

  /// Nothing of a sum.
  std::optional<LargeFiniteLaw> law(double n) const;

 private:
  class Solution;
  static LargeMoments moments_of(const Refined<Solution>& solutions, double n);
  std::unique_ptr<Refined<Solution>> solutions_;
};

}  // namespace ramify
