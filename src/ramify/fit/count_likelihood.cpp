#include "ramify/fit/count_likelihood.hpp"

#include <cmath>
#include <numbers>

#include <ceres/jet.h>

#include "ramify/core/contract.hpp"
#include "ramify/fit/family_fit.hpp"

namespace ramify {
namespace {

/// The density's logarithm splits into this.
template <class T>
struct Gaussian {
  T log_determinant, misfit;
};

/// Counts are taken in units of the root of their mean + 1/12.
/// @param quantity  a number of the reading, of type T
template <class T, class Quantity>
Gaussian<T> gaussian(const ObservedCounts& counts, const CountReading& reading, Quantity quantity) {
  using std::exp;
  Gaussian<T> found{T(0.0), T(0.0)};
  std::vector<T> whitened;  // L^-1 (M - m)
  for (std::size_t k = 1; k <= reading.orders; ++k) {
    const std::size_t row = CountReading::row(k);
    const T log_unit = quantity(row), log_diagonal = quantity(row + k);
    const double count = k < counts.streams.size() ? static_cast<double>(counts.streams[k]) : 0;
    T rest = (count + rounding_variance) * exp(-log_unit / 2.0) - exp(log_unit / 2.0);
    for (std::size_t j = 1; j < k; ++j) rest -= quantity(row + j) * whitened[j - 1];
    whitened.push_back(rest * exp(-log_diagonal));
    found.log_determinant += log_unit + 2.0 * log_diagonal;
    found.misfit += whitened.back() * whitened.back();
  }
  return found;
}

/// The sum of the three terms.
template <class T, class Quantity>
T minus_log_likelihood(const ObservedCounts& counts, const CountReading& reading, Quantity quantity) {
  const Gaussian<T> density = gaussian<T>(counts, reading, quantity);
  const double constant = static_cast<double>(reading.orders) * std::log(2 * std::numbers::pi);
  return (density.log_determinant + density.misfit + constant) / 2.0 - quantity(reading.size() - 1);
}

/// @tparam dimensions  parameters
template <int dimensions>
void with_gradient(const ObservedCounts& counts, const CountReading& reading,
                   const std::vector<double>& values, const std::vector<double>& slopes, double& value,
                   double* gradient) {
  using Jet = ceres::Jet<double, dimensions>;
  const auto quantity = [&](std::size_t q) {
    Jet jet(values[q]);
    for (int i = 0; i < dimensions; ++i) jet.v[i] = slopes[static_cast<std::size_t>(i) * values.size() + q];
    return jet;
  };
  const Jet found = minus_log_likelihood<Jet>(counts, reading, quantity);
  value = found.a;
  for (int i = 0; i < dimensions; ++i) gradient[i] = found.v[i];
}

}  // namespace

CountReading ObservedCounts::reading() const {
  std::size_t orders = 1;
  while (orders < streams.size() && streams[orders] >= enough) ++orders;
  return {orders, top()};
}

Objective count_objective(const CountSurface& surface, const ObservedCounts& counts) {
  RAMIFY_EXPECTS(surface.n() == counts.n());
  const CountReading reading = counts.reading();
  const auto evaluate = [&surface, counts, reading](std::span<const double> at, double& value,
                                                    double* gradient) {
    std::vector<double> values, slopes;
    if (!surface.read(at, reading, values, slopes)) return false;
    if (gradient == nullptr || at.empty())
      value = minus_log_likelihood<double>(counts, reading, [&](std::size_t q) { return values[q]; });
    else if (at.size() == 1)
      with_gradient<1>(counts, reading, values, slopes, value, gradient);
    else
      with_gradient<2>(counts, reading, values, slopes, value, gradient);
    return true;
  };
  const SearchBox box = search_box(surface.family());
  return {evaluate, box.low, box.high};
}

CountFitness count_fitness(const CountSurface& surface, const ObservedCounts& counts,
                           std::span<const double> searched) {
  const CountReading reading = counts.reading();
  const std::vector<double> values = surface.computed(searched, reading);
  const auto quantity = [&values](std::size_t q) { return values[q]; };
  return {-minus_log_likelihood<double>(counts, reading, quantity),
          gaussian<double>(counts, reading, quantity).misfit};
}

double count_misfit(const CountSurface& surface, const ObservedCounts& counts,
                    std::span<const double> searched) {
  std::vector<double> values, slopes;
  const CountReading reading = counts.reading();
  if (!surface.read(searched, reading, values, slopes)) return std::nan("");
  return gaussian<double>(counts, reading, [&](std::size_t q) { return values[q]; }).misfit;
}

}  // namespace ramify
