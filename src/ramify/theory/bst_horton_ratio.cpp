#include "ramify/theory/bst_horton_ratio.hpp"

#include <cstddef>
#include <ranges>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

// The right sides are polynomials, so the Taylor coefficients of the unknowns follow one from the other. With
// these two, a step is exact to 1e-22; the series converge for |step| < pi/2 or so.
constexpr std::size_t terms = 24;
constexpr double step = 0.25;

using Series = std::vector<Precise>;  ///< coefficients about the present time

Precise product_term(const Series& f, const Series& g, std::size_t n) {
  Precise sum = 0;
  for (std::size_t i = 0; i <= n; ++i) sum += f[i] * g[n - i];
  return sum;
}

/// D_k from D_(k-1). The equation is D_k' = D_k + D_(k-1) (D_(k-1) - 2 D_k): one product instead of two.
Series order_series(const Precise& now, const Series& below) {
  Series series{now}, other;
  for (std::size_t n = 0; n + 1 < terms; ++n) {
    other.push_back(below[n] - 2 * series[n]);
    series.push_back((series[n] + product_term(below, other, n)) / static_cast<double>(n + 1));
  }
  return series;
}

/// M_(k+1) from D_(k-1) - D_k.
Series stream_series(const Precise& now, const Series& gap) {
  Series series{now};
  for (std::size_t n = 0; n + 1 < terms; ++n)
    series.push_back((series[n] + product_term(gap, gap, n)) / static_cast<double>(n + 1));
  return series;
}

Precise after_step(const Series& series) {
  Precise sum = 0;
  for (const auto& coefficient : std::views::reverse(series)) sum = sum * step + coefficient;
  return sum;
}

/// One step of all orders: reached holds D_0, D_1, ..., streams M_1, M_2, ...
void advance(std::vector<Precise>& reached, std::vector<Precise>& streams) {
  Series below(terms, 0);
  below[0] = 1;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const Series here = order_series(reached[k], below);
    Series gap;
    for (std::size_t n = 0; n < terms; ++n) gap.push_back(below[n] - here[n]);
    streams[k] = after_step(stream_series(streams[k], gap));
    reached[k] = after_step(here);
    below = here;
  }
}

/// Aitken's method: the limits of the geometric sequences through every three neighbours.
std::vector<Precise> extrapolated(const std::vector<Precise>& sequence) {
  std::vector<Precise> limits;
  for (std::size_t i = 2; i < sequence.size(); ++i) {
    const Precise before = sequence[i - 1] - sequence[i - 2], last = sequence[i] - sequence[i - 1];
    limits.push_back(sequence[i] - last * last / (last - before));
  }
  return limits;
}

}  // namespace

std::vector<Precise> bst_stream_densities(int orders) {
  RAMIFY_EXPECTS(orders >= 1 && orders <= 20);
  const auto count = static_cast<std::size_t>(orders);
  std::vector<Precise> reached(count, 0), streams(count, 0);
  // Order k is reached near t = k log R < 1.12 k; what it gains 16 later is e^(-48) of the whole.
  const int steps = static_cast<int>((1.12 * orders + 16) / step);
  for (int i = 0; i < steps; ++i) advance(reached, streams);
  const Precise shrink = exp(Precise(-steps * step));
  for (auto& density : streams) density *= shrink;
  return streams;
}

Rounded bst_horton_ratio() {
  const auto densities = bst_stream_densities(10);
  std::vector<Precise> ratios;
  for (std::size_t k = 1; k < densities.size(); ++k) ratios.push_back(densities[k - 1] / densities[k]);
  const auto limits = extrapolated(extrapolated(extrapolated(ratios)));
  const Precise& limit = limits.back();
  const Precise change = abs(limit - limits[limits.size() - 2]);
  const auto value = static_cast<double>(limit);
  return {value, static_cast<double>(change + abs(limit - value) + 1e-20)};
}

}  // namespace ramify
