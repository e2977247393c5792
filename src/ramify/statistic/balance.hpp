#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "ramify/statistic/exact_law.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// BALANCE number (B16): an edge to a child no larger than any of its siblings counts 1, every other edge 0;
/// the maximum over root-to-leaf paths of the sum. Equal siblings both count 1. An external node has 0. Needs
/// labels that are sizes. Every edge that counts at least halves the number of external nodes, so B <=
/// log2(n+1).
class Balance {
 public:
  using Value = std::uint8_t;

  Value external() const { return 0; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels& sizes, const Values& balances) const {
    const auto smallest = *std::min_element(sizes.begin(), sizes.end());
    Value best = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      // An only child has no sibling to be smaller than: its edge counts 0.
      const bool counts = sizes.size() > 1 && sizes[i] == smallest;
      best = std::max(best, static_cast<Value>(balances[i] + (counts ? 1 : 0)));
    }
    return best;
  }

  /// P(B = k), B the larger of 1 + B of the smaller child and B of the larger; 1 + the maximum where the
  /// sizes are equal.
  static constexpr std::array<JoinTerm, 2> unequal{
      {{LawForm::at, -1, LawForm::below, 1}, {LawForm::below, -1, LawForm::at, 0}}};
  static constexpr std::array<JoinTerm, 2> equal{
      {{LawForm::at, -1, LawForm::below, 0}, {LawForm::below, -1, LawForm::at, -1}}};
  /// P(B >= k).
  static constexpr std::array<JoinTerm, 2> upper_unequal{
      {{LawForm::from, -1, LawForm::any, 0}, {LawForm::below, -1, LawForm::from, 0}}};
  static constexpr std::array<JoinTerm, 2> upper_equal{
      {{LawForm::from, -1, LawForm::any, 0}, {LawForm::below, -1, LawForm::from, -1}}};
  static constexpr JoinRule rule{unequal, equal, upper_unequal, upper_equal};
  static constexpr BoundedJoin recurrence{&rule};
};

/// The same of a tree that may have one-child nodes or three children: sizes are numbers of external nodes,
/// as in a trie (B15). In a strict binary tree internal nodes compare alike, and labels say how many there
/// are.
class BalanceByLeaves {
 public:
  struct Value {
    Size leaves;
    std::uint8_t balance;
  };

  Value external() const { return {1, 0}; }

  template <class Label, class Labels, class Values>
  Value join(const Label&, const Labels&, const Values& below) const {
    Size leaves = 0, smallest = below[0].leaves;
    for (const Value& child : below) {
      leaves += child.leaves;
      smallest = std::min(smallest, child.leaves);
    }
    std::uint8_t best = 0;
    for (const Value& child : below) {
      const bool counts = below.size() > 1 && child.leaves == smallest;
      best = std::max(best, static_cast<std::uint8_t>(child.balance + (counts ? 1 : 0)));
    }
    return {leaves, best};
  }
};

}  // namespace ramify
