#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace ramify {

/// Which orders of a tree an estimator of a ratio reads.
enum class OrderRange : std::uint8_t {
  all,
  below_top,  ///< without the highest order, whose one stream may be cut
  inner,      ///< without the lowest order, which depends on what a map or scanner sees, and the highest
  dense,      ///< the orders of OrderSpan::many streams or more: where the law's covariances are enough
};
inline constexpr std::array order_ranges{OrderRange::all, OrderRange::below_top, OrderRange::inner,
                                         OrderRange::dense};

/// What the name of an estimator ends in: "", "_below_top", "_inner", "_dense".
std::string_view suffix_of(OrderRange range);

/// Orders first..last, leaf order 0.
struct OrderSpan {
  std::size_t first, last;

  std::size_t size() const { return last - first + 1; }

  template <class Value>
  std::span<const Value> of(std::span<const Value> values) const {
    return values.subspan(first, size());
  }

  static constexpr double many = 30;

  friend bool operator==(const OrderSpan&, const OrderSpan&) = default;
};

/// The orders of a range; nothing where fewer than two are left.
/// @param counts  of streams of the orders 0..S
std::optional<OrderSpan> orders_of(OrderRange range, std::span<const double> counts);

}  // namespace ramify
