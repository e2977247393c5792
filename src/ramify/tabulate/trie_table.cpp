#include "ramify/tabulate/trie_table.hpp"

#include <array>
#include <cmath>

#include "ramify/core/memory.hpp"
#include "ramify/model/model.hpp"
#include "ramify/model/trie.hpp"

namespace ramify {
namespace {

/// look(replicate, strings) for every trie of the request.
template <class Look>
void each_trie(const TrieRequest& request, Look look) {
  const Model model = Model::make(Trie::info(), std::array{request.rule.p});
  require_domain("trie", positive("epsilon"), request.rule.epsilon);
  if (!request.strings.empty()) {
    GivenTrieStrings strings(request.strings);
    look(0, strings);
    return;
  }
  const StreamKey key{request.seed, model.stream_cell(request.rule.n)};
  for (std::uint64_t replicate = 0; replicate < request.replicates; ++replicate) {
    RandomTrieStrings strings(request.rule.n, request.rule.p, key, replicate);
    look(replicate, strings);
  }
}

/// Of a table of all nodes: as measured at p = 0.01 and 1/2.
double node_table_bytes(const TrieRequest& request, Size n) {
  constexpr double row_bytes = 1100, path_copies = 3;
  const double p = request.rule.p, entropy = -p * std::log(p) - (1 - p) * std::log1p(-p);
  const double path = std::log(static_cast<double>(n)) / entropy;
  const Model model = Model::make(Trie::info(), std::array{p});
  return static_cast<double>(request.replicates) * model.grown().expected_nodes(n) *
         (row_bytes + path_copies * path);
}

}  // namespace

Table trie_zone_table(const TrieRequest& request, const Cancellation& cancellation) {
  Table table({"p", "n", "epsilon", "replicate", "nodes_a", "nodes_b", "nodes_c", "exceptions",
               "largest_b_star", "b_star_bound", "longest_b", "longest_b_bound", "balance", "balance_bound"});
  const TrieZoneRule& rule = request.rule;
  each_trie(request, [&](std::uint64_t replicate, TrieStrings& strings) {
    const TrieZones zones = measure_trie_zones(rule, strings, {}, cancellation);
    table.add(Row()
                  .summary(rule.p)
                  .whole(rule.n)
                  .summary(rule.epsilon)
                  .whole(replicate)
                  .whole(zones.nodes_a)
                  .whole(zones.nodes_b)
                  .whole(zones.nodes_c)
                  .whole(zones.exceptions)
                  .whole(zones.largest_b_star)
                  .summary(b_star_bound(rule))
                  .whole(zones.longest_b)
                  .summary(longest_b_bound(rule))
                  .whole(zones.balance)
                  .summary(trie_balance_bound(rule)));
  });
  return table;
}

Table trie_node_table(const TrieRequest& request, const Cancellation& cancellation) {
  require_memory("a row for every node", "--n", request.rule.n,
                 [&](Size n) { return node_table_bytes(request, n); });
  constexpr std::array<const char*, 3> names{"A", "B", "C"};
  Table table({"replicate", "path", "level", "strings", "expected_strings", "probability", "zone"});
  each_trie(request, [&](std::uint64_t replicate, TrieStrings& strings) {
    const auto add_row = [&](const TrieNode& node) {
      const double q = std::exp(node.log_q);
      table.add(Row()
                    .whole(replicate)
                    .text(node.path)
                    .whole(node.path.size())
                    .whole(node.strings)
                    .summary(static_cast<double>(request.rule.n) * q)
                    .summary(q)
                    .text(names[static_cast<std::size_t>(node.zone)]));
    };
    measure_trie_zones(request.rule, strings, add_row, cancellation);
  });
  return table;
}

}  // namespace ramify
