#include "ramify/fit/count_likelihood.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <ceres/jet.h>
#include <ceres/loss_function.h>

#include "ramify/core/contract.hpp"
#include "ramify/fit/family_fit.hpp"

namespace ramify {
namespace {

/// The determinant of the covariances, and the orders' distances from what those below let expect.
template <class T>
struct Whitened {
  T log_determinant;
  std::vector<T> residuals;  // L^-1 (M - m)

  T misfit() const {
    T sum(0.0);
    for (const T& residual : residuals) sum += residual * residual;
    return sum;
  }
};

/// Counts are taken in units of the root of their mean + 1/12.
/// @param quantity  a number of the reading, of type T
template <class T, class Quantity>
Whitened<T> whitened(const ObservedCounts& counts, const CountReading& reading, Quantity quantity) {
  using std::exp;
  Whitened<T> found{T(0.0), {}};
  for (std::size_t k = 1; k <= reading.orders; ++k) {
    const std::size_t row = CountReading::row(k);
    const T log_unit = quantity(row), log_diagonal = quantity(row + k);
    const double count = k < counts.streams.size() ? static_cast<double>(counts.streams[k]) : 0;
    T rest = (count + rounding_variance) * exp(-log_unit / 2.0) - exp(log_unit / 2.0);
    for (std::size_t j = 1; j < k; ++j) rest -= quantity(row + j) * found.residuals[j - 1];
    found.residuals.push_back(rest * exp(-log_diagonal));
    found.log_determinant += log_unit + 2.0 * log_diagonal;
  }
  return found;
}

/// rho(z^2), and its slope by z^2.
std::array<double, 2> huber(double square) {
  std::array<double, 3> rho{};
  ceres::HuberLoss(huber_scale).Evaluate(square, rho.data());
  return {rho[0], rho[1]};
}

double huber_loss(double square) {
  return huber(square)[0];
}

template <int dimensions>
ceres::Jet<double, dimensions> huber_loss(const ceres::Jet<double, dimensions>& square) {
  const auto [value, slope] = huber(square.a);
  return {value, slope * square.v};
}

/// log of the integral of exp(-rho(z^2)/2): a Gaussian's within the scale c, and 2 exp(-c^2/2)/c beyond.
double log_normaliser(CountDensity density) {
  const double whole = std::sqrt(2 * std::numbers::pi), c = huber_scale;
  if (density == CountDensity::gaussian) return std::log(whole);
  return std::log(whole * std::erf(c / std::numbers::sqrt2) + 2 * std::exp(-c * c / 2) / c);
}

/// The sum of the terms.
template <class T, class Quantity>
T minus_log_likelihood(const ObservedCounts& counts, const CountReading& reading, CountDensity density,
                       Quantity quantity) {
  const Whitened<T> orders = whitened<T>(counts, reading, quantity);
  T lost = orders.log_determinant;
  for (const T& residual : orders.residuals) {
    const T square = residual * residual;
    lost += density == CountDensity::huber ? huber_loss(square) : square;
  }
  const double constant = static_cast<double>(reading.orders) * log_normaliser(density);
  return lost / 2.0 + constant - quantity(reading.size() - 1);
}

/// @tparam dimensions  parameters
template <int dimensions>
void with_gradient(const ObservedCounts& counts, const CountReading& reading, CountDensity density,
                   const std::vector<double>& values, const std::vector<double>& slopes, double& value,
                   double* gradient) {
  using Jet = ceres::Jet<double, dimensions>;
  const auto quantity = [&](std::size_t q) {
    Jet jet(values[q]);
    for (int i = 0; i < dimensions; ++i) jet.v[i] = slopes[static_cast<std::size_t>(i) * values.size() + q];
    return jet;
  };
  const Jet found = minus_log_likelihood<Jet>(counts, reading, density, quantity);
  value = found.a;
  for (int i = 0; i < dimensions; ++i) gradient[i] = found.v[i];
}

}  // namespace

CountReading ObservedCounts::reading() const {
  std::size_t orders = 1;
  while (orders < streams.size() && streams[orders] >= enough) ++orders;
  return {orders, top()};
}

Objective count_objective(const CountSurface& surface, const ObservedCounts& counts, CountDensity density) {
  RAMIFY_EXPECTS(surface.n() == counts.n());
  const CountReading reading = counts.reading();
  const auto evaluate = [&surface, counts, reading, density](std::span<const double> at, double& value,
                                                             double* gradient) {
    std::vector<double> values, slopes;
    if (!surface.read(at, reading, values, slopes)) return false;
    if (gradient == nullptr || at.empty())
      value =
          minus_log_likelihood<double>(counts, reading, density, [&](std::size_t q) { return values[q]; });
    else if (at.size() == 1)
      with_gradient<1>(counts, reading, density, values, slopes, value, gradient);
    else
      with_gradient<2>(counts, reading, density, values, slopes, value, gradient);
    return true;
  };
  const SearchBox box = search_box(surface.family());
  return {evaluate, box.low, box.high};
}

CountFitness count_fitness(const CountSurface& surface, const ObservedCounts& counts,
                           std::span<const double> searched, CountDensity density) {
  const CountReading reading = counts.reading();
  const std::vector<double> values = surface.computed(searched, reading);
  const auto quantity = [&values](std::size_t q) { return values[q]; };
  const Whitened<double> orders = whitened<double>(counts, reading, quantity);
  return {-minus_log_likelihood<double>(counts, reading, density, quantity), orders.misfit(),
          orders.residuals};
}

double count_misfit(const CountSurface& surface, const ObservedCounts& counts,
                    std::span<const double> searched) {
  std::vector<double> values, slopes;
  const CountReading reading = counts.reading();
  if (!surface.read(searched, reading, values, slopes)) return std::nan("");
  return whitened<double>(counts, reading, [&](std::size_t q) { return values[q]; }).misfit();
}

}  // namespace ramify
