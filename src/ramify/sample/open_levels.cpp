#include "ramify/sample/open_levels.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/sample/sampling_method.hpp"

namespace ramify {

double open_levels(const Model& model, Size size) {
  if (!model.is_split()) return model.grown().expected_nodes(size);
  const double n = static_cast<double>(size);
  const SplitFraction fraction = model.character().fraction;
  if (const double e = depth_exponent(fraction); e > 0) return std::min(n, 6 * std::pow(n, e));
  const auto* constant = std::get_if<ConstantFraction>(&fraction);
  const double smallest_share = constant != nullptr ? std::min(constant->p, 1 - constant->p) : 0.1;
  return std::min(n, std::log(n + 1) / -std::log1p(-smallest_share) + 50);
}

double growing_bytes(const Model& model, Size n, FoldSet pass) {
  constexpr double stored_node = 14, small_open_node = 28, open_node = 150;
  if (!model.is_split()) return open_levels(model, n) * stored_node;
  return open_levels(model, n) * (orders_and_height.contains(pass) ? small_open_node : open_node);
}

}  // namespace ramify
