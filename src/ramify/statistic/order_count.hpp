#pragma once

#include <cstddef>

namespace ramify {

/// A count of a tree: its nodes or its streams of one order, leaf order 0.
struct OrderCount {
  enum class Of { nodes, streams };
  Of of;
  std::size_t order;

  friend bool operator==(const OrderCount&, const OrderCount&) = default;
};

}  // namespace ramify
