#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "ramify/io/table.hpp"
#include "ramify/statistic/trie_zones.hpp"

namespace ramify {

/// Tries to look at: given strings, or `replicates` of random ones.
struct TrieRequest {
  TrieZoneRule rule;                 ///< n: of the given strings, if there are
  std::vector<std::string> strings;  ///< none: random ones
  std::uint64_t seed = 1996;
  std::uint64_t replicates = 1;
};

/// A row a trie: the zones of Theorem B.1 and what the proof bounds, with the bounds. Throws Error where p or
/// epsilon is out of its domain, Interrupted when cancelled.
Table trie_zone_table(const TrieRequest& request, const Cancellation& cancellation);

/// A row a node of every trie, in preorder: path, level, strings (the cardinality C), n q, q and zone.
/// Throws as trie_zone_table does, and where the rows would not fit into memory.
Table trie_node_table(const TrieRequest& request, const Cancellation& cancellation);

}  // namespace ramify
