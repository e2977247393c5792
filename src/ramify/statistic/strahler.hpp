#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ramify/statistic/exact_law.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The order of a node from those of its children, and whether the node begins a stream of that order.
struct JoinedOrder {
  std::uint8_t order;
  std::uint8_t begins;  ///< 1 where no child has the order, else 0
};

/// max + [both attain it].
inline JoinedOrder join_orders(const Pair<std::uint8_t>& below) {
  const std::uint8_t left = below[0], right = below[1];
  const std::uint8_t higher = left > right ? left : right, lower = left > right ? right : left;
  const auto order = static_cast<std::uint8_t>(higher > lower ? higher : lower + 1);
  return {order, static_cast<std::uint8_t>(order - higher)};
}

/// max + [two or more attain it]: the k-ary rule B22.
inline JoinedOrder join_orders(std::span<const std::uint8_t> below) {
  std::uint8_t highest = 0;
  std::size_t attained = 0;
  for (const std::uint8_t order : below) {
    if (order > highest) {
      highest = order;
      attained = 0;
    }
    attained += order == highest ? 1 : 0;
  }
  const auto begins = static_cast<std::uint8_t>(attained < 2 ? 0 : 1);
  return {static_cast<std::uint8_t>(highest + begins), begins};
}

/// The Horton-Strahler number alone (B6): 0 for an external node, then join_orders.
class Strahler {
 public:
  using Value = std::uint8_t;

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& orders) const {
    return join_orders(orders).order;
  }

  /// P(S = k): one child has order k and the other less, or both have k-1.
  static constexpr std::array<JoinTerm, 3> ways{{{LawForm::at, 0, LawForm::below, 0},
                                                 {LawForm::below, 0, LawForm::at, 0},
                                                 {LawForm::at, -1, LawForm::at, -1}}};
  /// P(S >= k): one child has k or more and the other less than k-1, or both have k-1 or more.
  static constexpr std::array<JoinTerm, 3> upper{{{LawForm::from, 0, LawForm::below, -1},
                                                  {LawForm::below, -1, LawForm::from, 0},
                                                  {LawForm::from, -1, LawForm::from, -1}}};
  static constexpr JoinRule rule{ways, ways, upper, upper};
  static constexpr BoundedJoin recurrence{&rule};
};

}  // namespace ramify
