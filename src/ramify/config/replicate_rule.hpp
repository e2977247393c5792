#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// How many trees each size gets: many small ones, few large ones.
struct ReplicateRule {
  /// (largest n, trees), by n upwards: the first bound that covers n decides.
  std::vector<std::pair<Size, std::uint64_t>> up_to;
  /// Trees of the sizes above all bounds.
  std::optional<std::uint64_t> above;

  /// Trees of size n. Throws Error where no part of the rule covers n.
  std::uint64_t count(Size n) const;
};

}  // namespace ramify
