#include "support/reference_laws.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace ramify::test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

std::vector<double> scaled(const std::vector<Real>& weights) {
  Real sum = 0;
  for (const Real& w : weights) sum += w;
  std::vector<double> law;
  for (const Real& w : weights) law.push_back(static_cast<double>(w / sum));
  return law;
}

/// C(m,k) p^k q^(m-k), k = 0..m; 50 digits have the exponents for it.
std::vector<Real> binomial(Size m, double p) {
  const Real left = p, right = 1 - Real(p);
  std::vector<Real> weights{boost::multiprecision::pow(right, static_cast<int>(m))};
  for (Size k = 0; k < m; ++k) weights.push_back(weights.back() * Real(m - k) / Real(k + 1) * left / right);
  return weights;
}

/// The weights 1..m-1 of Binomial(m, p).
std::vector<double> inner_binomial(Size m, double p) {
  const auto all = binomial(m, p);
  return scaled(std::vector<Real>(all.begin() + 1, all.end() - 1));
}

/// Integral of x^(a-1) (1-x)^(b-1) over [from, to], to <= 1/2 or so: only the end at 0 is singular.
double beta_piece(double a, double b, double from, double to) {
  using boost::math::quadrature::gauss_kronrod;
  // The rule's own error bound is far above its error: asked for 1e-9, it reaches 1e-13 (tests/exact).
  constexpr unsigned depth = 10;
  constexpr double tolerance = 1e-9;
  if (from > 0 || a >= 1) {
    // The density at the middle is taken out, or the integral underflows for a = b = 1000.
    const auto density = [&](double x) {
      return std::exp((a - 1) * std::log(2 * x) + (b - 1) * std::log(2 * (1 - x)));
    };
    return gauss_kronrod<double, 61>::integrate(density, from, to, depth, tolerance);
  }
  // u = x^a takes the singularity away.
  const auto density = [&](double u) { return std::pow(1 - std::pow(u, 1 / a), b - 1) / a; };
  const double scale = std::exp((a - 1) * std::log(2.0) + (b - 1) * std::log(2.0));
  return scale * gauss_kronrod<double, 61>::integrate(density, 0.0, std::pow(to, a), depth, tolerance);
}

/// a (a+1) ... (a+k-1) / k!, k = 0..m.
std::vector<Real> rising_factorials(double a, Size m) {
  std::vector<Real> rising{1};
  for (Size k = 0; k < m; ++k) rising.push_back(rising.back() * (Real(a) + Real(k)) / Real(k + 1));
  return rising;
}

/// How often k of m draws from an urn of a and b balls are of the first kind, each ball drawn being put back
/// with one more of its kind (Polya): Binomial(m, X), X ~ beta(a,b). k = 0..m.
std::vector<Real> urn(Size m, double a, double b) {
  const auto first = rising_factorials(a, m), second = rising_factorials(b, m);
  Real all = 1;
  for (Size k = 0; k < m; ++k) all *= (Real(a) + Real(b) + Real(k)) / Real(k + 1);
  std::vector<Real> law;
  for (Size k = 0; k <= m; ++k) law.push_back(first[k] * second[m - k] / all);
  return law;
}

std::vector<double> appended_zero(std::vector<double> law) {
  law.push_back(0);
  return law;
}

}  // namespace

std::vector<double> uniform_law(Size n) {
  return std::vector<double>(n, 1 / static_cast<double>(n));
}

std::vector<double> split_law(Size n, double x) {
  std::vector<double> law(n, 0.0);
  for (Size i = 0; i < n; ++i)
    if (static_cast<double>(i) <= x * static_cast<double>(n) &&
        x * static_cast<double>(n) < static_cast<double>(i + 1))
      law[i] = 1;
  return law;
}

std::vector<double> beta_law(Size n, double a, double b) {
  const double size = static_cast<double>(n);
  if (n == 1) return {1.0};
  std::vector<double> law(n);
  for (Size i = 0; i < n; ++i) {
    const double from = static_cast<double>(i) / size, to = static_cast<double>(i + 1) / size;
    // From the nearer end: mirrored above 1/2.
    law[i] = from + to <= 1
                 ? beta_piece(a, b, from, to)
                 : beta_piece(b, a, static_cast<double>(n - 1 - i) / size, static_cast<double>(n - i) / size);
  }
  const double sum = std::accumulate(law.begin(), law.end(), 0.0);
  for (double& p : law) p /= sum;
  return law;
}

std::vector<double> beta_multinomial_law(Size n, double a, double b) {
  std::vector<double> law;
  for (const Real& p : urn(n - 1, a, b)) law.push_back(static_cast<double>(p));
  return law;
}

std::vector<double> catalan_law(Size n) {
  std::vector<Real> numbers{1};  // C_i
  for (Size i = 0; i + 1 < n; ++i) numbers.push_back(numbers.back() * Real(2 * (2 * i + 1)) / Real(i + 2));
  std::vector<Real> weights;
  for (Size i = 0; i < n; ++i) weights.push_back(numbers[i] * numbers[n - 1 - i]);
  return scaled(weights);
}

std::vector<double> dst_law(Size n, double p) {
  return scaled(binomial(n - 1, p));
}

std::vector<double> patricia_law(Size n, double p) {
  return inner_binomial(n + 1, p);
}

std::vector<double> aldous_law(Size n, double beta) {
  std::vector<Real> f{1};  // Gamma(beta+1+k) / (Gamma(beta+2) k!), k = 1..n
  for (Size k = 1; k < n; ++k) f.push_back(f.back() * (Real(beta) + Real(k + 1)) / Real(k + 1));
  std::vector<Real> weights;
  for (Size i = 0; i < n; ++i) weights.push_back(f[i] * f[n - 1 - i]);
  return scaled(weights);
}

std::vector<double> ford_law(Size n, double a) {
  if (a == 1) return chain_law(n);
  const Size m = n + 1;
  const Real weight = a;
  std::vector<Real> g{0, 1};  // G(m) / m!, m = 1, 2, ...
  for (Size i = 1; i < m; ++i) g.push_back(g.back() * (Real(i) - weight) / Real(i + 1));
  std::vector<double> law;
  for (Size k = 1; k < m; ++k) {
    const Real pairs = Real(k) * Real(m - k) / (Real(m) * Real(m - 1));  // C(m-2,k-1) / C(m,k)
    law.push_back(static_cast<double>(g[k] * g[m - k] / g[m] * (weight / 2 + (1 - 2 * weight) * pairs)));
  }
  return law;
}

std::vector<double> complete_law(Size n) {
  Size left = 0;  // nodes that come to node 2 on the way up, i -> i/2, to the root
  for (Size node = 2; node <= n; ++node) {
    Size above = node;
    while (above > 3) above /= 2;
    if (above == 2) ++left;
  }
  std::vector<double> law(n, 0.0);
  law[left] = 1;
  return law;
}

std::vector<double> chain_law(Size n) {
  if (n == 1) return {1.0};
  std::vector<double> law(n, 0.0);
  law[0] = law[n - 1] = 0.5;
  return law;
}

std::vector<double> thesis_binomial_law(Size n, double p) {
  auto weights = binomial(n, p);
  weights.pop_back();
  return scaled(weights);
}

std::vector<double> long_beta_multinomial_law(Size n, double a, double b) {
  auto weights = urn(n, a, b);
  weights.pop_back();
  return scaled(weights);
}

std::vector<double> short_uniform_law(Size n) {
  return n == 1 ? uniform_law(1) : appended_zero(uniform_law(n - 1));
}

std::vector<double> short_beta_law(Size n, double a, double b) {
  return n == 1 ? uniform_law(1) : appended_zero(beta_law(n - 1, a, b));
}

std::vector<double> short_patricia_law(Size n, double p) {
  return n == 1 ? uniform_law(1) : appended_zero(inner_binomial(n, p));
}

std::vector<double> short_catalan_law(Size n) {
  return n == 1 ? uniform_law(1) : appended_zero(catalan_law(n - 1));
}

std::vector<double> short_aldous_law(Size n, double beta) {
  return n == 1 ? uniform_law(1) : appended_zero(aldous_law(n - 1, beta));
}

std::vector<double> short_ford_law(Size n, double a) {
  return n == 1 ? uniform_law(1) : appended_zero(ford_law(n - 1, a));
}

std::vector<double> right_complete_law(Size n) {
  auto law = complete_law(n);
  std::reverse(law.begin(), law.end());
  return law;
}

std::vector<double> short_complete_law(Size n) {
  return n == 1 ? uniform_law(1) : appended_zero(complete_law(n - 1));
}

std::vector<double> left_chain_law(Size n) {
  std::vector<double> law(n, 0.0);
  law[n - 1] = 1;
  return law;
}

}  // namespace ramify::test
