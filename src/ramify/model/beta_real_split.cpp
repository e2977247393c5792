#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "ramify/model/beta.hpp"

namespace ramify {
namespace {

constexpr double near_the_end = 9;        // leaves: powers are singular beyond
constexpr double steep = 2;               // change of the log density over a cell
constexpr double hardly_changing = 1e-3;  // and where two points give 15 digits

/// The probability of the cell that ends where x of n leaves lie below it, X ~ beta(a,b), near 0.
double near_0(double a, double b, double x, double n) {
  return boost::math::ibeta(a, b, std::min(1.0, x / n)) - boost::math::ibeta(a, b, (x - 1) / n);
}

/// In the middle of a steep law: a difference of the smaller tails.
double steep_cell(double a, double b, double x, double n) {
  const double low = (x - 1) / n, high = std::min(1.0, x / n);
  if (boost::math::ibeta(a, b, high) < 0.5) return near_0(a, b, x, n);
  return boost::math::ibetac(a, b, low) - boost::math::ibetac(a, b, high);
}

}  // namespace

/// The cell (x-1, x)/n of the density, n = x+y-1: its integral, from both ends as powers of u = (x-1+t)/n and
/// 1-u = (y-t)/n.
RealSplit Beta::real_split() const {
  const double log_beta = boost::math::lgamma(a_) + boost::math::lgamma(b_) - boost::math::lgamma(a_ + b_);
  return SmoothSplit{
      [a = a_, b = b_, log_beta](double x, double y) {
        const double n = x + y - 1;
        if (x < near_the_end) return std::log(near_0(a, b, x, n));
        if (y < near_the_end) return std::log(near_0(b, a, y, n));
        const double left = (a - 1) / (x - 0.5), right = (b - 1) / (y - 0.5);
        const double change =
            std::max({std::abs(left), std::abs(right), std::abs(left / x), std::abs(right / y)});
        if (std::abs(left - right) > steep || std::abs(left / x + right / y) > steep)
          return std::log(steep_cell(a, b, x, n));
        const double middle = (a - 1) * std::log((x - 0.5) / n) + (b - 1) * std::log((y - 0.5) / n);
        // Beside the middle, t = 1/2.
        const auto density = [&](double t) {
          return std::exp((a - 1) * std::log1p((t - 0.5) / (x - 0.5)) +
                          (b - 1) * std::log1p((0.5 - t) / (y - 0.5)));
        };
        constexpr double off = std::numbers::inv_sqrt3 / 2;
        const double mean = change < hardly_changing
                                ? (density(0.5 - off) + density(0.5 + off)) / 2
                                : boost::math::quadrature::gauss<double, 8>::integrate(density, 0.0, 1.0);
        return middle + std::log(mean) - std::log(n) - log_beta;
      },
      true};
}

}  // namespace ramify
