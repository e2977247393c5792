#pragma once

#include <vector>

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/gauss_jacobi.hpp"
#include "ramify/theory/lattice_stencil.hpp"

namespace ramify {

/// The travelling wave of the Horton-Strahler number of beta splits: P(S_n > k) ~ psi(log n - k log R).
///
/// psi and R solve, for all y (docs/theory/horton-ratio.md),
///   0 = integral of x^(a-1) (1-x)^(b-1) G dx over (0,1),
///   G = psi(y1) (1 - psi'(y2)) + psi(y2) (1 - psi'(y1)) + psi'(y1) psi'(y2) - psi(y),
///   y1 = y + log x, y2 = y + log(1-x), psi'(y) = psi(y + log R),
/// with psi(-infinity) = 0 (faster than e^y), psi(0) = 1/2, psi(infinity) = 1. G is O(x) and O(1-x) at the
/// ends, so that a, b > -1 is enough.
///
/// Unknown are phi = psi(y) e^(-y) on an even lattice of y, and log R; the equation is met at the points of
/// the lattice. Between them phi is interpolated, below them it is 0, above them psi is 1.
class HortonWave {
 public:
  /// Lattice and quadrature.
  struct Mesh {
    double spacing;
    int below;   ///< points with y < 0
    int above;   ///< points with y > 0
    int points;  ///< of the quadrature in x
  };

  /// A first guess, psi(y) = 1 - 2^(-e^y), R = 3.
  HortonWave(const BetaSplit& split, const Mesh& mesh);

  /// The same wave on another mesh.
  HortonWave resampled(const Mesh& mesh) const;

  /// From order k-1 to order k: solves the equation for psi with psi' held, and moves psi back to psi(0) =
  /// 1/2.
  ///
  /// From any front that is 0 far below, this converges to the wave, by a factor an order that nears 1 as X
  /// concentrates (0.11 for the BST). Returns by how much log R changed. Cost: O(n^2 (n + points)) for n
  /// lattice points, as for refine.
  double advance();

  /// One step of Newton's method for psi and R together. Returns the largest correction.
  double refine();

  double log_ratio() const { return log_ratio_; }

  /// The least number of lattice points that hold the wave: beyond them psi e^(-y) < 1e-18 or 1 - psi <
  /// 1e-13.
  Mesh extent() const;

 private:
  struct Child;
  struct Stencils;
  struct System;
  struct Row;
  enum class Slopes { none, same_order, both_orders };

  int size() const { return mesh_.below + 1 + mesh_.above; }
  double position(int i) const { return (i - mesh_.below) * mesh_.spacing; }
  double phi_at_point(int i) const;
  double psi(double y) const;
  double median() const;
  std::vector<double> shifted_phi(const Mesh& mesh, double shift) const;
  System equations(double log_ratio, Slopes slopes) const;
  static double add_split(const Child& left, const Child& right, double weight, const Row& row);

  BetaSplit split_;
  Mesh mesh_;
  Quadrature rule_;
  std::vector<double> phi_;
  double log_ratio_;
};

}  // namespace ramify
