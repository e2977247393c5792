#include "ramify/family/beta_cell.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace ramify {
namespace {

constexpr double most_change = 4;  // of the log-density over a panel

CellRule gauss_legendre() {
  using Gauss = boost::math::quadrature::gauss<double, CellRule::points>;
  constexpr std::size_t half = CellRule::points / 2;
  CellRule rule{};
  for (std::size_t q = 0; q < half; ++q) {
    const double x = Gauss::abscissa()[q];
    rule.at[half + q] = (1 + x) / 2;
    rule.at[half - 1 - q] = (1 - x) / 2;
    rule.weight[half + q] = rule.weight[half - 1 - q] = Gauss::weights()[q] / 2;
  }
  return rule;
}

/// From 0 to h = 1/n.
LogCell first_cell(const LogBeta& beta, double n) {
  const double h = 1 / n, a = beta.a, both = beta.a + beta.b;
  double term = 1, sum = 1, by_a = 0, by_b = 0, term_by_a = 0, term_by_b = 0;
  for (double k = 0; term > 1e-17 * sum || (both + k) * h > a + 1 + k; ++k) {
    term *= (both + k) / (a + 1 + k) * h;
    term_by_b += 1 / (both + k);
    term_by_a += 1 / (both + k) - 1 / (a + 1 + k);
    sum += term;
    by_a += term * term_by_a;
    by_b += term * term_by_b;
  }
  const double log_h = std::log(h), log_rest = std::log1p(-h);
  return {a * log_h + beta.b * log_rest - std::log(a) - beta.value + std::log(sum),
          log_h - 1 / a - beta.by_a + by_a / sum, log_rest - beta.by_b + by_b / sum};
}

/// log of the density in the cell, t of (0,1) along it, without its constant.
struct CellDensity {
  double a, b, i, j, n;

  double log_x(double t) const { return std::log((i + t) / n); }
  double log_rest(double t) const { return std::log((j + 1 - t) / n); }
  double operator()(double t) const { return (a - 1) * log_x(t) + (b - 1) * log_rest(t); }

  /// Where it is largest: it has one mode, or falls from an end, or has changed little.
  double mode() const {
    if (a > 1 && b > 1) return std::clamp((a - 1) * n / (a + b - 2) - i, 0.0, 1.0);
    return (*this)(0) >= (*this)(1) ? 0 : 1;
  }
};

/// The integral of a density over its largest value, and those of its derivatives, panel by panel.
struct CellSum {
  const CellDensity& density;
  double largest, panels;
  double sum = 0, by_a = 0, by_b = 0;

  /// Whether the panel adds anything.
  bool add(double panel) {
    const CellRule& rule = CellRule::get();
    const double before = sum;
    for (std::size_t q = 0; q < CellRule::points; ++q) {
      const double t = (panel + rule.at[q]) / panels;
      const double log_x = density.log_x(t), log_rest = density.log_rest(t);
      const double part =
          rule.weight[q] / panels * std::exp((density.a - 1) * log_x + (density.b - 1) * log_rest - largest);
      sum += part;
      by_a += part * log_x;
      by_b += part * log_rest;
    }
    return sum > before;
  }
};

}  // namespace

const CellRule& CellRule::get() {
  static const CellRule rule = gauss_legendre();
  return rule;
}

LogBeta::LogBeta(double first, double second)
    : a(first),
      b(second),
      value(boost::math::lgamma(a) + boost::math::lgamma(b) - boost::math::lgamma(a + b)),
      by_a(boost::math::digamma(a) - boost::math::digamma(a + b)),
      by_b(boost::math::digamma(b) - boost::math::digamma(a + b)) {}

LogBeta LogBeta::exchanged() const {
  LogBeta other;
  other.a = b;
  other.b = a;
  other.value = value;
  other.by_a = by_b;
  other.by_b = by_a;
  return other;
}

std::size_t panels_needed(double a, double b, double i, double j) {
  const double left = (a - 1) / i, right = (b - 1) / j;
  const double slope = std::max(std::abs(left - (b - 1) / (j + 1)), std::abs((a - 1) / (i + 1) - right));
  const double bend = 2 * std::sqrt(std::abs(left) / i + std::abs(right) / j);
  return static_cast<std::size_t>(std::max(1.0, std::ceil(std::max(slope, bend) / most_change)));
}

LogCell log_cell(const LogBeta& beta, double i, double j) {
  const double n = i + j + 1;
  if (i == 0) return first_cell(beta, n);
  const CellDensity density{beta.a, beta.b, i, j, n};
  const auto panels = static_cast<double>(panels_needed(beta.a, beta.b, i, j));
  const double mode = density.mode(), middle = std::min(panels - 1, std::floor(mode * panels));
  CellSum part{density, density(mode), panels};
  for (double panel = middle; panel < panels && part.add(panel); ++panel) {
  }
  for (double panel = middle - 1; panel >= 0 && part.add(panel); --panel) {
  }
  return {part.largest + std::log(part.sum / n) - beta.value, part.by_a / part.sum - beta.by_a,
          part.by_b / part.sum - beta.by_b};
}

}  // namespace ramify
