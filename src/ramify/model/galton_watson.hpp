#pragma once

#include "ramify/model/grown_model.hpp"

namespace ramify {

struct ModelInfo;

/// A Galton-Watson tree with 0, 1 or 2 children of probabilities p0, p1, p2 given that it has n nodes in all
/// (A20).
///
/// The number of nodes with two children has the weights N!/(n0! n1! n2!) p0^n0 p1^n1 p2^n2, n0 = n2+1; the
/// children of all nodes then are a random arrangement of these numbers, turned to the only rotation that is
/// a tree (the cycle lemma, Dvoretzky and Motzkin 1947). p0 and p2 only matter through p0 p2/p1^2. O(n).
class GaltonWatson final : public GrownModel {
 public:
  /// Throws Error unless p0, p2 > 0 and p1 >= 0 sum to 1 within 1e-9.
  GaltonWatson(double p0, double p1, double p2);

  Tree grow(Size n, Stream& stream, const Cancellation& cancellation,
            std::vector<std::uint64_t>* labels) const override;

  double expected_nodes(Size n) const override { return static_cast<double>(n); }
  std::size_t largest_order(Size n) const override;
  Size largest_size() const override { return Size{1} << 32; }

  /// n >= 1, odd where p1 = 0.
  void require_size(Size n) const override;

  static const ModelInfo& info();

 private:
  Size draw_forks(Size n, Stream& stream) const;

  double p1_;
  double ratio_;  ///< p0 p2 / p1^2
};

}  // namespace ramify
