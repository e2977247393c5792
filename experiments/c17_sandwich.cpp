// C17 (Kruszewski 1996, Lemmas B.3 and B.4): in every binary tree the fill level is at most the
// Horton-Strahler number, and that at most the balance number. A trie and the PATRICIA tree that is left when
// its one-child nodes are taken out have the same order and balance number, which is why Theorem B.3 speaks
// of both; the fill level of the trie is the lower one.
//
// All three of a tree follow from those of its two subtrees and their sizes: so does the set of values that
// trees of n nodes can have, and every tree of up to 64 nodes is looked at.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <vector>

#include "sandwich.hpp"
#include <fmt/format.h>

#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/fill_level.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

/// F, S and B of a tree.
struct Levels {
  std::uint8_t fill = 0, order = 0, balance = 0;
  friend auto operator<=>(const Levels&, const Levels&) = default;
};

/// Of a node with these subtrees, two or one, which have so many external nodes.
template <std::size_t children>
Levels joined(const std::array<Levels, children>& below, const std::array<Size, children>& leaves) {
  std::array<std::uint8_t, children> fills, orders;
  std::array<BalanceByLeaves::Value, children> balances;
  for (std::size_t i = 0; i < children; ++i) {
    fills[i] = below[i].fill;
    orders[i] = below[i].order;
    balances[i] = {leaves[i], below[i].balance};
  }
  return {FillLevel().join(Size{}, leaves, fills), Strahler().join(Size{}, leaves, orders),
          BalanceByLeaves().join(Size{}, leaves, balances).balance};
}

/// A trie and the PATRICIA tree that is in it.
struct Twins {
  Levels trie, patricia;
  friend auto operator<=>(const Twins&, const Twins&) = default;
};

/// What tries can be that have `leaves` strings and so many one-child nodes: [leaves][one-child nodes].
using TriesBySize = std::vector<std::vector<std::set<Twins>>>;

/// Adds the tries with two subtrees, the left one no larger: a mirrored tree has the same values.
void add_forks(TriesBySize& tries, Size leaves, Size only_children) {
  auto& found = tries[leaves][only_children];
  for (Size left = 1; 2 * left <= leaves; ++left)
    for (Size on_left = 0; on_left <= only_children; ++on_left)
      for (const Twins& a : tries[left][on_left])
        for (const Twins& b : tries[leaves - left][only_children - on_left]) {
          const std::array<Size, 2> sizes{left, leaves - left};
          found.insert(
              {joined(std::array{a.trie, b.trie}, sizes), joined(std::array{a.patricia, b.patricia}, sizes)});
        }
}

/// Adds those with a one-child node on top: with two strings at least, or it would not be shared.
void add_only_children(TriesBySize& tries, Size leaves, Size only_children) {
  if (leaves < 2 || only_children == 0) return;
  for (const Twins& below : tries[leaves][only_children - 1])
    tries[leaves][only_children].insert({joined(std::array{below.trie}, std::array{leaves}), below.patricia});
}

TriesBySize all_tries(Size most_leaves, Size most_only_children) {
  TriesBySize tries(most_leaves + 1, std::vector<std::set<Twins>>(most_only_children + 1));
  tries[1][0].insert(Twins());
  for (Size leaves = 2; leaves <= most_leaves; ++leaves)
    for (Size only_children = 0; only_children <= most_only_children; ++only_children) {
      add_forks(tries, leaves, only_children);
      add_only_children(tries, leaves, only_children);
    }
  return tries;
}

/// The largest of a difference over all tries of up to so many strings and one-child nodes.
Basis largest_over_tries(Size most_leaves, Size most_only_children, int (*difference)(const Twins&)) {
  int largest = -static_cast<int>(most_leaves);
  for (const auto& of_leaves : all_tries(most_leaves, most_only_children))
    for (const auto& twins : of_leaves)
      for (const Twins& each : twins) largest = std::max(largest, difference(each));
  const std::string tries = most_only_children == 0
                                ? "every binary tree"
                                : fmt::format("every trie with up to {} one-child nodes", most_only_children);
  const auto value = static_cast<double>(largest);
  return {EvidenceKind::exact,
          Standing::proved,
          value,
          {value, value},
          static_cast<double>(most_leaves - 1),
          fmt::format("largest over {} of up to {} external nodes, by the values that subtrees of every size "
                      "can have",
                      tries, most_leaves),
          ""};
}

constexpr const char* sandwich_conventions = "external nodes counted, S(external) = 0";

/// Of a difference that is 0 at most.
Statement never_above(const char* part, const char* text, const char* source, NamedValue rival) {
  return {part,        text, source, sandwich_conventions, Relation::at_most, "0", 0, {std::move(rival)},
          std::nullopt};
}

ClaimPart of_trees(Statement statement, int (*difference)(const Twins&)) {
  constexpr Size leaves = 65;
  return part_without_trees(std::move(statement), [difference](const Evidence&) {
    return largest_over_tries(leaves, 0, difference);
  });
}

ClaimPart of_tries(Statement statement, int (*difference)(const Twins&)) {
  constexpr Size leaves = 16, only_children = 5;
  return part_without_trees(std::move(statement), [difference](const Evidence&) {
    return largest_over_tries(leaves, only_children, difference);
  });
}

}  // namespace

std::vector<ClaimPart> sandwich_parts() {
  return {of_trees(never_above("C17.5", "F - S <= 0 in every binary tree", "K96 Lemma B.4",
                               {"1, full levels counted from 1", 1}),
                   [](const Twins& of) { return int{of.trie.fill} - of.trie.order; }),
          of_trees(never_above("C17.6", "S - B <= 0 in every binary tree", "K96 Lemma B.3",
                               {"1, S with leaf order 1", 1}),
                   [](const Twins& of) { return int{of.trie.order} - of.trie.balance; }),
          of_tries(never_above("C17.7", "S and B of a trie are those of its PATRICIA tree",
                               "K96 B.1, Theorem B.3", {"1, a one-child node raises S or B", 1}),
                   [](const Twins& of) {
                     return std::max(std::abs(of.trie.order - of.patricia.order),
                                     std::abs(of.trie.balance - of.patricia.balance));
                   }),
          of_tries(never_above("C17.8", "F of a trie is at most that of its PATRICIA tree", "K96 B.3",
                               {"1, one-child nodes make levels full", 1}),
                   [](const Twins& of) { return int{of.trie.fill} - of.patricia.fill; })};
}

}  // namespace ramify
