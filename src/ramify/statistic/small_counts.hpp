#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace ramify {

/// Counts of the orders 1..4 side by side in one word, 16 bits each: what the tally of a small tree is packed
/// into, so that adding one to another is one addition.
class SmallCounts {
 public:
  static constexpr std::size_t largest_order = 4;
  static constexpr std::uint64_t largest_count = 0xffff;

  void increment(std::size_t order, std::uint64_t by = 1) { lanes_ += by << shift(order); }
  std::uint64_t operator[](std::size_t order) const { return lanes_ >> shift(order) & largest_count; }

  SmallCounts& operator+=(SmallCounts other) {
    lanes_ += other.lanes_;
    return *this;
  }
  friend auto operator<=>(const SmallCounts&, const SmallCounts&) = default;

 private:
  static constexpr std::size_t shift(std::size_t order) { return 16 * (order - 1); }

  std::uint64_t lanes_ = 0;
};

}  // namespace ramify
