// C22.3, C22.4: what is left of E S_n - log_4 n for equiprobable binary trees (Flajolet, Raoult, Vuillemin
// 1979): C + sum over m != 0 of a_m n^(chi_m/2), chi_m = 2 pi i m/log 2,
//   C = 1/2 - (gamma + 2)/(2 log 2) + log_2 pi,   a_m = (chi_m - 1) Gamma(chi_m/2) zeta(chi_m)/log 2,
// up to O(1/n). Period 1 in log_4 n, so that exact means at eight sizes evenly over a period give C, and the
// amplitude 2 |a_1|, without the other harmonics below the seventh (10^-16).
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "catalan_counts.hpp"
#include <fmt/format.h>

#include "ramify/large/large_law.hpp"

namespace ramify {
namespace {

constexpr double ln2 = std::numbers::ln2, pi = std::numbers::pi;
constexpr double period_start = 1e12;

double mean_constant() {
  return 0.5 - (std::numbers::egamma + 2) / (2 * ln2) + std::log2(pi);
}

/// zeta(i y), y of some ten: Euler and Maclaurin from 1000 on; error below 1e-13.
std::complex<double> zeta_on_axis(double y) {
  constexpr double start = 1000;
  const std::complex<double> s(0, y);
  std::complex<double> sum =
      std::pow(start, 1.0 - s) / (s - 1.0) + 0.5 * std::pow(start, -s) + s * std::pow(start, -s - 1.0) / 12.0;
  for (double k = 1; k < start; ++k) sum += std::pow(k, -s);
  return sum;
}

/// 2 |a_1|; |Gamma(i y)|^2 = pi/(y sinh(pi y)).
double first_amplitude() {
  const double y = pi / ln2;
  const double gamma = std::sqrt(pi / (y * std::sinh(pi * y)));
  return 2 * std::hypot(2 * y, 1) * gamma * std::abs(zeta_on_axis(2 * y)) / ln2;
}

/// E S_n - log_4 n at eight sizes evenly over a period.
struct Period {
  static constexpr std::size_t places = 8;
  std::array<double, places> residuals;
  double error = 0;  ///< of each

  /// |sum over j of residual_j e^(-2 pi i j/8)|/8 of a harmonic.
  double harmonic(int number) const {
    std::complex<double> sum = 0;
    for (std::size_t j = 0; j < places; ++j)
      sum += residuals[j] * std::polar(1.0, -2 * pi * number * static_cast<double>(j) / places);
    return std::abs(sum) / places;
  }
};

Period exact_period(const Cancellation& cancellation) {
  std::vector<double> sizes;
  for (std::size_t j = 0; j < Period::places; ++j)
    sizes.push_back(std::round(period_start * std::pow(4.0, static_cast<double>(j) / Period::places)));
  const LargeLaw law(Model::parse("catalan"), statistic::strahler.law.recurrence, sizes, cancellation);
  Period period{{}, 0};
  constexpr double smaller_terms = 1e-10;  // rounding of the logarithms, and terms that fall like 1/n
  for (std::size_t j = 0; j < Period::places; ++j) {
    const Approximation mean = law.moments(sizes[j]).mean;
    period.residuals[j] = mean.value - std::log(sizes[j]) / std::log(4.0);
    period.error = std::max(period.error, mean.error + smaller_terms);
  }
  return period;
}

Basis of_period(double value, double error) {
  return extrapolated(
      value, error, 4 * period_start,
      fmt::format("E S_n - log_4 n at eight sizes evenly over the period from n = {:.0e} on; bound: the "
                  "errors of the laws",
                  period_start));
}

Statement of_fluctuation(int part, std::string text, std::string formula, double theory) {
  return {fmt::format("C22.{}", part),
          std::move(text),
          "K96 B.1.2; Flajolet, Raoult, Vuillemin 1979",
          "order of the root, leaf order 0",
          Relation::equals,
          std::move(formula),
          theory,
          {},
          std::nullopt};
}

}  // namespace

std::vector<ClaimPart> catalan_fluctuation_parts() {
  Statement constant = of_fluctuation(3, "E S_n - log_4 n is C on average over a period, catalan",
                                      "1/2 - (gamma+2)/(2 log 2) + log_2 pi", mean_constant());
  constant.rivals = {{"leaf order 1", mean_constant() + 1},
                     {"log_4 of the leaves pi n, the first terms alone", 0.5 + std::log2(pi) - 1 / ln2}};
  Statement amplitude =
      of_fluctuation(4, "E S_n - log_4 n swings about C with the period 4 in n: its first harmonic, catalan",
                     "2 |(chi-1) Gamma(chi/2) zeta(chi)|/log 2, chi = 2 pi i/log 2", first_amplitude());
  amplitude.rivals = {{"none, E S_n - log_4 n settles", 0},
                      {"half of it, one of two conjugate terms", first_amplitude() / 2}};
  return {part_without_trees(std::move(constant),
                             [](const Evidence& evidence) {
                               const Period period = exact_period(evidence.cancellation);
                               return of_period(period.harmonic(0), period.error);
                             }),
          part_without_trees(std::move(amplitude), [](const Evidence& evidence) {
            const Period period = exact_period(evidence.cancellation);
            return of_period(2 * period.harmonic(1), 2 * period.error);
          })};
}

}  // namespace ramify
