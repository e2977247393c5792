#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace ramify {

/// Lagrange's interpolation between the 16 nearest points of the lattice 0, +-1, +-2, ...
///
/// f(i + shift) = sum over j of weight[j] f(i + first + j), for every i alike, up to O(f^(16)). Points lie
/// evenly on both sides: the weights stay small (their magnitudes sum to less than 3).
struct LatticeStencil {
  static constexpr int width = 16;

  int first;
  std::array<double, width> weight;

  explicit LatticeStencil(double shift) {
    const double cell = std::floor(shift);
    first = static_cast<int>(cell) - (width / 2 - 1);
    const double at = shift - first;
    for (int j = 0; j < width; ++j) {
      double product = 1;
      for (int k = 0; k < width; ++k)
        if (k != j) product *= (at - k) / (j - k);
      weight[static_cast<std::size_t>(j)] = product;
    }
  }
};

}  // namespace ramify
