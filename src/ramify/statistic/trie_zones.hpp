#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The strings of a trie (B19): how many of those through a node go left, bit 0.
///
/// Ask for nodes in preorder, 0 before 1; a node without strings need not be asked for.
class TrieStrings {
 public:
  virtual ~TrieStrings() = default;

  /// n.
  virtual Size count() const = 0;

  /// Of `strings` >= 1 strings through a node of that level (root: 0), the first of which has `first` others
  /// before it in the order of strings.
  virtual Size left(Size first, Size strings, Size level) = 0;
};

/// n random strings of independent bits, 0 with probability p: K ~ Bin(strings, p) go left (A12). The trie of
/// the model trie(p) of the same key and replicate.
class RandomTrieStrings final : public TrieStrings {
 public:
  /// Throws Error unless 0 < p < 1.
  RandomTrieStrings(Size n, double p, StreamKey key, std::uint64_t replicate);

  Size count() const override { return n_; }
  Size left(Size first, Size strings, Size level) override;

 private:
  Size n_;
  double p_;
  Stream stream_;
  Stream beyond_;  // for the bits of a string that has parted from all others
};

/// Strings that are given; beyond their end they go on with 0.
class GivenTrieStrings final : public TrieStrings {
 public:
  /// Throws Error for another character than 0 or 1, a string that comes twice or begins another, or none.
  explicit GivenTrieStrings(std::vector<std::string> strings);

  Size count() const override { return strings_.size(); }
  Size left(Size first, Size strings, Size level) override;

 private:
  std::vector<std::string> strings_;  // sorted
};

/// Where a node of the infinite trie stands in the proof of Kruszewski 1996, Theorem B.1: by n q, the
/// expected number of strings through it: a, n q >= n^epsilon; c, n q <= n^-epsilon (the thesis has both <
/// and > there, so that equality is nowhere); b, between them.
enum class TrieZone { a, b, c };

struct TrieZoneRule {
  Size n;
  double p;        ///< probability of bit 0, left
  double epsilon;  ///< > 0

  TrieZone zone(double log_q) const;
};

/// A node of the finite trie: one through which two strings go, or the first through which only one goes.
struct TrieNode {
  std::string path;  ///< bits from the root; its length is the level
  Size strings;      ///< C, 1 or more
  double log_q;      ///< log of the probability that a string goes through it
  TrieZone zone;
};

/// What the proof of Theorem B.1 looks at, on one trie (C14).
struct TrieZones {
  std::uint64_t nodes_a = 0, nodes_b = 0, nodes_c = 0;  ///< of the finite trie
  /// Nodes of zone a below the root, with strings or without, of which "C < C' if and only if q < q'", C' and
  /// q' of the sibling, does not hold: 0 is the event A_0 of Lemma B.1.
  std::uint64_t exceptions = 0;
  Size largest_b_star = 0;      ///< most strings through a node of b with a child in c (Lemma B.2)
  std::uint64_t longest_b = 0;  ///< most nodes of b on a path of the infinite trie
  std::uint64_t balance = 0;    ///< B_n (B15)
};

/// Walks through the trie, and through zones a and b of the infinite one: O(n^(1+epsilon)/p + trie) time.
/// @param visit  called with every node of the finite trie in preorder; may be empty
/// Throws Interrupted when cancelled.
TrieZones measure_trie_zones(const TrieZoneRule& rule, TrieStrings& strings,
                             const std::function<void(const TrieNode&)>& visit,
                             const Cancellation& cancellation = {});

/// The proof's bound on longest_b, 2 + 2 epsilon log n / log(1/(1-m)), m = min(p, 1-p).
double longest_b_bound(const TrieZoneRule& rule);

/// The proof's bound on largest_b_star, 1 + 1/epsilon; in probability, as n grows.
double b_star_bound(const TrieZoneRule& rule);

/// The proof's bound on B_n, 3 + 1/epsilon + (1 + 2 epsilon log(1/m)/log(1/(1-m))) log n/log(1/m); in
/// probability, as n grows.
double trie_balance_bound(const TrieZoneRule& rule);

}  // namespace ramify
