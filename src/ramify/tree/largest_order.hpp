#pragma once

#include <bit>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The largest Horton-Strahler order, leaf order 0, of trees with so many external nodes: floor(log2), and 0
/// for none. A node of order k has 2^k external nodes below it at least.
constexpr std::size_t largest_strahler_order(Size external_nodes) {
  return external_nodes == 0 ? 0 : static_cast<std::size_t>(std::bit_width(external_nodes)) - 1;
}

}  // namespace ramify
