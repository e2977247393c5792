#include "ramify/model/catalan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ramify/model/model_info.hpp"

namespace ramify {
namespace {

constexpr std::size_t exact_terms = 64;

constexpr std::array<double, exact_terms> small_central_binomials() {
  std::array<double, exact_terms> g{};
  g[0] = 1;
  for (std::size_t i = 0; i + 1 < exact_terms; ++i)
    g[i + 1] = g[i] * static_cast<double>(2 * i + 1) / static_cast<double>(2 * i + 2);
  return g;
}

double level(Size n, double g_n, Size k) {
  const double size = static_cast<double>(n);
  const double balance = (size - 2 * static_cast<double>(k)) / size;
  return balance * Catalan::central_binomial(k) * Catalan::central_binomial(n - k) / g_n;
}

/// C_i / 4^i.
double catalan_number(Size i) {
  return Catalan::central_binomial(i) / static_cast<double>(i + 1);
}

Size guess(Size n, double u) {
  const double size = static_cast<double>(n);
  const double r = u * size / std::sqrt((size + 0.25) * std::numbers::inv_pi);
  const double v = r / std::sqrt(4 + r * r);
  const double y = 2 / ((4 + r * r) * (1 + v));  // (1-v)/2 without cancellation
  return static_cast<Size>(std::max(0.0, (size + 0.5) * y - 0.25));
}

}  // namespace

double Catalan::central_binomial(Size i) {
  static constexpr auto table = small_central_binomials();
  if (i < exact_terms) return table[i];
  const double x = static_cast<double>(i);
  const double t = 1 / x;
  // The asymptotic series of Gamma(i+1/2) / Gamma(i+1); the next term is below 1e-15 at i = 64.
  const double series =
      1 + t * (-1.0 / 8 +
               t * (1.0 / 128 +
                    t * (5.0 / 1024 + t * (-21.0 / 32768 + t * (-399.0 / 262144 + t * (869.0 / 4194304))))));
  return series * std::numbers::inv_sqrtpi / std::sqrt(x);
}

Size Catalan::smaller_half(Size n, double u) {
  const Size last = (n - 1) / 2;
  const double g_n = central_binomial(n);
  Size k = std::min(guess(n, u), last);
  while (k > 0 && level(n, g_n, k) < u) --k;
  while (k < last && level(n, g_n, k + 1) >= u) ++k;
  return k;
}

WeightWindow Catalan::window(Size n, double) const {
  const double total = 4 * catalan_number(n);
  std::vector<double> weights(n);
  for (Size i = 0; i < n; ++i) weights[i] = catalan_number(i) * catalan_number(n - 1 - i) / total;
  return {0, std::move(weights)};
}

WeightWindow Catalan::Rows::window(Size n) {
  for (Size i = catalan_.size(); i < n; ++i) catalan_.push_back(catalan_number(i));
  std::vector<double> weights(n);
  for (Size i = 0; i < n; ++i) weights[i] = catalan_[i] * catalan_[n - 1 - i];
  return {0, std::move(weights)};
}

SplitCharacter Catalan::character() const {
  // 1.3 s, 0.7: heights and depths spread over 13.6 sqrt(n) values.
  return {BetaFraction{-0.5, -0.5, Scatter::strings}, true, {}, {3000, 2048}};
}

/// c(x) c(y) / (4 c(z)), c(x) = Gamma(x-1/2) / (sqrt(pi) Gamma(x+1)) = C_(x-1) / 4^(x-1).
RealSplit Catalan::real_split() const {
  const auto excess = [](double x) { return -log_gamma_excess(x - 0.5, 1.5); };
  return SmoothSplit{[excess](double x, double y) {
                       const double z = x + y;
                       return -1.5 * (std::log((x - 0.5) / (z - 0.5)) + std::log(y - 0.5)) + excess(x) +
                              excess(y) - excess(z) - std::log(4 * std::sqrt(std::numbers::pi));
                     },
                     true};
}

const ModelInfo& Catalan::info() {
  static const ModelInfo info{
      .name = "catalan",
      .largest_n = largest_size(),
      .description = "equiprobable binary tree: left = i with C_i C_(n-1-i) / C_n",
      .source = "A15; Flajolet, Raoult, Vuillemin 1979",
      .make = [](std::span<const double>) -> AnyModel { return AnySplitLaw(Catalan()); }};
  return info;
}

}  // namespace ramify
