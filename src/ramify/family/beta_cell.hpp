#pragma once

#include <array>
#include <cstddef>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Gauss and Legendre's eight points on (0,1).
struct CellRule {
  static constexpr std::size_t points = 8;
  std::array<double, points> at;  ///< ascending; at[q] + at[points-1-q] = 1
  std::array<double, points> weight;

  static const CellRule& get();
};

/// What the density of beta(a,b) has without x: log B(a,b), and its derivatives.
struct LogBeta {
  double a, b;
  double value, by_a, by_b;

  LogBeta(double first, double second);
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

/// On how many equal panels the rule gives twelve digits, i >= 1: the density may change by e^4 over a panel.
std::size_t panels_needed(double a, double b, double i, double j);
/// One where |a-1|/i + |b-1|/j is no more.
inline constexpr double surely_even = 4;

/// The integral of the density from i/n to (i+1)/n, n = i+j+1 and i <= j, j > 0. Its log has absolute errors
/// below 1e-10.
///
/// i = 0: h^a (1-h)^b / (a B(a,b)) sum of (a+b)_k/(a+1)_k h^k, h = 1/n (DLMF 8.17.8, whose terms are all
/// positive), term by term. Otherwise by the rule on the panels needed, from the mode
/// outwards while they add anything.
LogCell log_cell(const LogBeta& beta, double i, double j);

}  // namespace ramify
