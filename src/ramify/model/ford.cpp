#include "ramify/model/ford.hpp"

#include <array>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "ramify/core/compensated_sum.hpp"
#include "ramify/model/beta_binomial.hpp"
#include "ramify/model/bst.hpp"
#include "ramify/model/catalan.hpp"
#include "ramify/model/model_info.hpp"

namespace ramify {

Ford::Ford(double alpha) : alpha_(alpha) {
  require_domain(info(), std::array{alpha});
}

/// Gamma(1-alpha)/Gamma(1-2 alpha) Gamma(m-2 alpha)/Gamma(m-alpha), the poles at alpha = 1/2 taken off.
double Ford::even_share(Size n) const {
  using boost::math::tgamma_delta_ratio;  // Gamma(z) / Gamma(z + delta)
  const double first = (1 - 2 * alpha_) / ((1 - alpha_) * tgamma_delta_ratio(2 - 2 * alpha_, alpha_));
  return first * tgamma_delta_ratio(static_cast<double>(n) + 1 - 2 * alpha_, alpha_);
}

WeightWindow Ford::window(Size n, double cutoff) const {
  if (alpha_ == 1) return Chain().window(n, cutoff);
  WeightWindow splits = BetaBinomial{n + 1, -alpha_, -alpha_}.window(1, n, 1, 0);
  for (Size left = 0; left < n; ++left) splits.weights[left] *= bracket(left, n);
  const double sum = compensated_sum(splits.weights);
  for (double& w : splits.weights) w /= sum;
  return splits;
}

SplitCharacter Ford::character() const {
  SplitFraction fraction = NoFraction{alpha_};
  if (alpha_ == 0) fraction = Bst().character().fraction;
  if (alpha_ == 0.5) fraction = Catalan().character().fraction;
  return {fraction, true, {.nanoseconds = 14}, {2048, 2048}};
}

/// The weights of aldous(-1-alpha) times the bracket.
RealSplit Ford::real_split() const {
  if (alpha_ == 1) return {};
  const auto lopsided = std::get<SmoothSplit>(Aldous(-1 - alpha_).real_split()).log_weight;
  return SmoothSplit{[lopsided, law = *this](double x, double y) {
                       return lopsided(x, y) + std::log(law.bracket_of_leaves(x, y));
                     },
                     false};
}

const ModelInfo& Ford::info() {
  static const ModelInfo info{
      .name = "ford",
      .parameters = {{.name = "alpha",
                      .domain = {.low = 0, .high = 1, .holds_low = true, .holds_high = true},
                      .remedy = "give a number from 0, the bst, to 1, the chain; 1/2 is catalan"}},
      .largest_n = largest_size(),
      .description = "alpha model: leaves grow out of edges of weight alpha, out of those to a leaf 1-alpha",
      .source = "Ford 2005",
      .make = [](std::span<const double> v) -> AnyModel { return AnySplitLaw(Ford(v[0])); }};
  return info;
}

}  // namespace ramify
