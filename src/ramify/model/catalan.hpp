#pragma once

#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/uniform.hpp"

namespace ramify {

/// Equiprobable binary tree (A15): uniform over the C_n = C(2n,n)/(n+1) trees with n internal nodes; also
/// segmental growth (A16) and the critical binary Galton-Watson tree given its size. n <= 2^50.
class Catalan {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    const double u = uniform_open(stream);
    return u < 0.5 ? smaller_half(n, 2 * u) : n - 1 - smaller_half(n, 2 * (1 - u));
  }

  /// P(left = i) = C_i C_(n-1-i) / C_n.
  WeightWindow window(Size n, double cutoff) const;

  class Rows;

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

  /// The left size at level u in (0,1) of the lower half of its law: the k <= (n-1)/2 with h(k) >= u >
  /// h(k+1), where
  ///   P(left < k) = (1 - h(k)) / 2,   h(k) = (1 - 2k/n) g_k g_(n-k) / g_n,   g_i = C(2i,i) / 4^i.
  /// The partial sums of C_i C_(n-1-i) telescope (checked against them in tests/exact), so inversion is
  /// exact: one guess from g_i ~ 1/sqrt(pi (i + 1/4)), then a step or two. O(1).
  static Size smaller_half(Size n, double u);

  /// g_i = C(2i,i) / 4^i, relative error below 1e-15.
  static double central_binomial(Size i);

  friend bool operator==(const Catalan&, const Catalan&) = default;
};

/// The split laws of size after size, from a table of C_i / 4^i.
class Catalan::Rows {
 public:
  explicit Rows(const Catalan&) {}

  /// C_i C_(n-1-i) / 4^(n-1), i = 0..n-1: not scaled. O(n).
  WeightWindow window(Size n);

 private:
  std::vector<double> catalan_;
};

}  // namespace ramify
