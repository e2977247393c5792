#pragma once

#include <optional>
#include <variant>

#include "ramify/model/registry.hpp"

namespace ramify {

/// The parameters of the limiting split fraction X ~ beta(a,b).
struct BetaSplit {
  double a;
  double b;

  /// Of a beta tree, floor or multinomial; a bst is beta(1,1), aldous(beta) beta(beta+1,beta+1) for beta >
  /// -1. Nothing for any other model.
  static std::optional<BetaSplit> of(const Model& model) {
    if (std::holds_alternative<Bst>(model.law())) return BetaSplit{1, 1};
    if (const auto* beta = std::get_if<Beta>(&model.law())) return BetaSplit{beta->a(), beta->b()};
    if (const auto* beta = std::get_if<BetaMultinomial>(&model.law())) return BetaSplit{beta->a(), beta->b()};
    if (const auto* aldous = std::get_if<Aldous>(&model.law()); aldous != nullptr && aldous->beta() > -1)
      return BetaSplit{aldous->beta() + 1, aldous->beta() + 1};
    return std::nullopt;
  }
};

}  // namespace ramify
