#pragma once

#include <optional>
#include <variant>

#include "ramify/model/model.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// A split whose limiting fraction is a constant.
///
/// Kept as the smaller of p and 1-p: the larger loses p's digits where p is small.
struct BinarySplit {
  Precise smaller;
  Scatter scatter;

  explicit BinarySplit(const ConstantFraction& fraction)
      : smaller(fraction.p <= 0.5 ? Precise(fraction.p) : 1 - Precise(fraction.p)),
        scatter(fraction.scatter) {}

  Precise larger() const { return 1 - smaller; }

  /// The constant fraction of a model; nothing where it is random or there is none.
  static std::optional<BinarySplit> of(const Model& model) {
    const SplitFraction fraction = model.character().fraction;
    const auto* constant = std::get_if<ConstantFraction>(&fraction);
    return constant != nullptr ? std::optional(BinarySplit(*constant)) : std::nullopt;
  }

  /// Of a model whose path of smaller children decides what lies near the root: where sizes scatter so far
  /// that they can be 0 (Scatter::binomial), no source says that it does.
  static std::optional<BinarySplit> of_smaller_path(const Model& model) {
    auto split = of(model);
    return split && split->scatter != Scatter::binomial ? split : std::nullopt;
  }
};

}  // namespace ramify
