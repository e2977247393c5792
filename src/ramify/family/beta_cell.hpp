#pragma once

#include <array>
#include <cstddef>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Gauss and Legendre's eight points on (0,1).
struct CellPoints {
  static constexpr std::size_t count = 8;
  std::array<double, count> at;  ///< ascending; at[q] + at[count-1-q] = 1
  std::array<double, count> weight;

  static const CellPoints& get();
};

/// What the density of beta(a,b) has without x: log B(a,b), and its derivatives.
struct LogBeta {
  double a, b;
  double value, by_a, by_b;

  LogBeta(double a, double b);
  LogBeta exchanged() const;

 private:
  LogBeta() = default;
};

/// log P(left = i) of beta(a,b), left = floor(nX), with its derivatives.
struct LogCell {
  double log, by_a, by_b;

  /// That of (b,a), seen from (a,b).
  LogCell exchanged() const { return {log, by_b, by_a}; }
};

/// Change of the log-density over the cell of i, by its slope and by its curvature.
double change_over_cell(double a, double b, double i, double j);

/// The largest change at which the eight points give twelve digits.
inline constexpr double most_change = 4;
/// The smallest i likewise.
inline constexpr double least_smaller = 3;

/// The integral of the density from i/n to (i+1)/n, n = i+j+1 and i <= j, j > 0. Its log has absolute errors
/// below 1e-10.
///
/// i = 0: h^a (1-h)^b / (a B(a,b)) sum of (a+b)_k/(a+1)_k h^k, h = 1/n (DLMF 8.17.8, whose terms are all
/// positive), term by term. Otherwise Gauss and Legendre's points on panels so short that the density changes
/// by e^4 over one of them.
LogCell log_cell(const LogBeta& beta, double i, double j);

}  // namespace ramify
