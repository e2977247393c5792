#pragma once

#include <optional>
#include <variant>

#include "ramify/model/registry.hpp"
#include "ramify/theory/precise.hpp"

namespace ramify {

/// A split whose limiting fraction is a constant: P(next bit is 0) of dst and patricia, x of split(x).
///
/// Kept as the smaller of p and 1-p: the larger loses p's digits where p is small.
struct BinarySplit {
  Precise smaller;

  explicit BinarySplit(double p) : smaller(p <= 0.5 ? Precise(p) : 1 - Precise(p)) {}

  Precise larger() const { return 1 - smaller; }

  /// The constant fraction of a model; nothing where it is random (bst, beta) or there is none (catalan).
  static std::optional<BinarySplit> of(const Model& model) {
    if (const auto* fixed = std::get_if<FixedSplit>(&model.law())) return BinarySplit(fixed->x());
    if (const auto* dst = std::get_if<Dst>(&model.law())) return BinarySplit(dst->p());
    if (const auto* patricia = std::get_if<Patricia>(&model.law())) return BinarySplit(patricia->p());
    return std::nullopt;
  }
};

}  // namespace ramify
