#pragma once

#include "ramify/core/rational.hpp"
#include "ramify/core/wide.hpp"
#include "ramify/model/split_law.hpp"

namespace ramify {

/// Deterministic split tree (A6): left = floor(nx) at every node. 0 < x < 1, n <= 2^50. Kruszewski
/// 1996, 2.5.1. x is the fraction that was written, 29/100 where that was 0.29, and the floor exact: in
/// double precision 100 x would be 28.999999999999996.
class FixedSplit {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = false;

  /// A double stands for the fraction Rational::of says. Throws Error unless 0 < x < 1.
  explicit FixedSplit(double x);

  /// @param x  the double nearest to `exact`. Throws Error unless 0 < x < 1.
  FixedSplit(double x, const Rational& exact);

  /// The nearest double.
  double x() const { return x_; }

  template <class Urbg>
  Size left(Size n, Urbg&) const {
    return left(n);
  }

  /// The product in double precision is less than 1 off: one step either way, as the remainder says.
  Size left(Size n) const {
    const auto near = static_cast<Size>(static_cast<double>(n) * x_);
    const WideProduct rest = multiply_wide(n, exact_.numerator) - multiply_wide(near, exact_.denominator);
    if (rest.high == ~std::uint64_t{0}) return near - 1;  // below 0
    return rest.high > 0 || rest.low >= exact_.denominator ? near + 1 : near;
  }

  /// 1 at floor(nx).
  WeightWindow window(Size n, double) const { return {left(n), {1.0}}; }

  SplitCharacter character() const;
  static const ModelInfo& info();

  friend bool operator==(const FixedSplit& a, const FixedSplit& b) { return a.exact_ == b.exact_; }

 private:
  double x_;
  Rational exact_;
};

}  // namespace ramify
