#pragma once

#include <optional>
#include <variant>

#include "ramify/model/model.hpp"

namespace ramify {

/// The parameters of a split fraction with a density proportional to x^(a-1) (1-x)^(b-1).
struct BetaSplit {
  double a;
  double b;

  /// Of a model whose limiting fraction is X ~ beta(a,b), a, b > 0.
  static std::optional<BetaSplit> of(const Model& model) {
    const auto cut = with_cut(model);
    return cut && cut->a > 0 && cut->b > 0 ? cut : std::nullopt;
  }

  /// The same with a, b > -1: where one is not positive, the density is that of splits cut off at 1/n.
  static std::optional<BetaSplit> with_cut(const Model& model) {
    const SplitFraction fraction = model.character().fraction;
    const auto* beta = std::get_if<BetaFraction>(&fraction);
    return beta != nullptr ? std::optional(BetaSplit{beta->a, beta->b}) : std::nullopt;
  }

  friend bool operator==(const BetaSplit&, const BetaSplit&) = default;
};

inline constexpr BetaSplit uniform_split{1, 1};        ///< of the bst
inline constexpr BetaSplit catalan_split{-0.5, -0.5};  ///< of the uniform tree

}  // namespace ramify
