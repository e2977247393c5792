// C2 (Kruszewski 1996, 3.1.1): S(T) <= log_2 n + 2 of every binary tree of n internal nodes. True and loose:
// the largest order is floor(log_2(n+1)), for a tree of order k has 2^k external nodes at least.
//
// The orders that trees of n nodes can have follow from those of their subtrees: all trees of a size at once.
// The complete tree has the largest.
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "claim.hpp"
#include "exact_range.hpp"
#include "one_way_trees.hpp"
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/tree/largest_order.hpp"

namespace ramify {
namespace {

constexpr const char* root_order = "order of the root, leaf order 0";

/// Bit k: some tree has order k.
using OrderBits = std::uint64_t;

/// Orders of trees whose left subtree has one of these orders, and the right one of those: the larger, which
/// is above the least of the others, or one more than both.
OrderBits joined(OrderBits left, OrderBits right) {
  const auto above_least = [](OrderBits bits) { return ~((bits & (~bits + 1)) * 2 - 1); };
  return (left & above_least(right)) | (right & above_least(left)) | (left & right) << 1;
}

std::size_t largest_bit(OrderBits bits) {
  return static_cast<std::size_t>(std::bit_width(bits)) - 1;
}

/// The largest order of all trees of every size 0..largest_n. O(n^2).
std::vector<std::size_t> largest_orders(Size largest_n, const Cancellation& cancellation) {
  std::vector<OrderBits> orders{1};
  std::vector<std::size_t> largest{0};
  for (Size n = 1; n <= largest_n; ++n) {
    if (cancellation.requested()) throw Interrupted();
    OrderBits bits = 0;
    for (Size left = 0; 2 * left < n; ++left) bits |= joined(orders[left], orders[n - 1 - left]);
    orders.push_back(bits);
    largest.push_back(largest_bit(bits));
  }
  return largest;
}

Basis worst_excess(const Cancellation& cancellation) {
  constexpr Size largest = 4096;
  constexpr double error = 1e-12;
  const auto orders = largest_orders(largest, cancellation);
  double worst = -HUGE_VAL;
  for (Size n = 1; n <= largest; ++n)
    worst = std::fmax(worst, static_cast<double>(orders[n]) - std::log2(static_cast<double>(n)) - 2);
  ExactRange excess;
  excess.add(worst);
  return excess.basis(largest, fmt::format("the largest of all trees at every n to {}", largest), error);
}

double sharp_bound(Size n) {
  return static_cast<double>(largest_strahler_order(n + 1));
}

Basis sharpness(const Cancellation& cancellation) {
  constexpr Size largest = 4096;
  const auto orders = largest_orders(largest, cancellation);
  ExactRange excess;
  for (Size n = 1; n <= largest; ++n) excess.add(static_cast<double>(orders[n]) - sharp_bound(n));
  return excess.basis(largest, fmt::format("the largest S of all trees at every n to {}", largest));
}

Basis complete_shortfall(const Cancellation& cancellation) {
  constexpr Size largest = 100'000;
  const auto orders = one_way_orders(Model::parse("complete"), largest, cancellation);
  ExactRange excess;
  for (Size n = 1; n <= largest; ++n) excess.add(static_cast<double>(orders[n]) - sharp_bound(n));
  return excess.basis(largest, fmt::format("the complete tree of every n to {}", largest));
}

std::vector<NamedValue> loose_bound() {
  return {{"1, what log_2 n + 2 leaves at least", 1}};
}

}  // namespace

Claim largest_order_claim() {
  const Statement bound{"C2.1",
                        "S - log_2 n - 2 <= 0, all binary trees",
                        "K96 3.1.1",
                        root_order,
                        Relation::at_most,
                        "0",
                        0,
                        {},
                        std::nullopt};
  const Statement sharp{"C2.2",
                        "the largest S = floor(log_2(n+1)): excess 0, all binary trees",
                        "K96 3.1.1, sharpened",
                        root_order,
                        Relation::equals,
                        "0",
                        0,
                        loose_bound(),
                        std::nullopt};
  const Statement complete{"C2.3",
                           "S = floor(log_2(n+1)): excess 0, complete",
                           "K96 3.1.1",
                           root_order,
                           Relation::equals,
                           "0",
                           0,
                           loose_bound(),
                           std::nullopt};
  return {
      "C2",
      "S(T) <= log_2 n + 2, and the complete tree has the largest order",
      "K96 3.1.1",
      {part_without_trees(bound, [](const Evidence& e) { return worst_excess(e.cancellation); }),
       part_without_trees(sharp, [](const Evidence& e) { return sharpness(e.cancellation); }),
       part_without_trees(complete, [](const Evidence& e) { return complete_shortfall(e.cancellation); })},
      {}};
}

}  // namespace ramify
