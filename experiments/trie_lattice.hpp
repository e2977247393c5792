#pragma once

#include <cstdint>
#include <vector>

#include "ramify/statistic/trie_zones.hpp"

namespace ramify {

/// What the proof of Kruszewski's Theorem B.1 counts in the infinite trie, exactly (C14). Nodes with the same
/// numbers of 0s and 1s on their paths are alike, so O(log^2 n) kinds of nodes are looked at. p < 1/2.
struct TrieZoneCounts {
  std::uint64_t longest_b = 0;  ///< most nodes of zone b on a path
  double a_nodes = 0;           ///< |A|
  double b_star_nodes = 0;      ///< |B*|, nodes of b with a child in c
  double b_star_above = 0;      ///< expected number of those with more than b_star_bound strings
};

TrieZoneCounts trie_zone_counts(const TrieZoneRule& rule);

/// How likely it is that the children of a node with c strings have them in the wrong order: K ~ Bin(c, p) go
/// to the less likely child.
struct WrongOrder {
  /// p < 1/2. O(largest^1.5).
  WrongOrder(double p, Size largest);

  std::vector<double> at_least;  ///< P(K >= c - K), of c = 0..largest
  std::vector<double> more;      ///< P(K > c - K)
};

/// E of the exceptions to the event A_0 of Lemma B.1 (TrieZones::exceptions).
/// @param wrong  of the same p, to n
double expected_exceptions(const TrieZoneRule& rule, const WrongOrder& wrong);

/// P(F_n < l), F_n the fill level of the p-trie of n strings, for n = 0, 1, ... as far as P(F_n < l-1) is
/// given: K ~ Bin(n,p) strings go left, and one of the two subtries is not full to level l-1. P(F_0 < l) = 1.
/// Sums of positive terms above 1e-60 of the largest. O(n^1.5) for all.
std::vector<double> not_full_to_next(const std::vector<double>& not_full, double p);

}  // namespace ramify
