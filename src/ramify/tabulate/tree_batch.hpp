#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/format/tree_format.hpp"
#include "ramify/io/table.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/statistic/registry.hpp"
#include "ramify/tree/recorded_tree.hpp"

namespace ramify {

/// Nodes of a tree in the mean, internal and external.
double expected_nodes(const Model& model, Size n);

/// Trees of one model, size and seed, replicate by replicate: what `ramify sample` prints.
///
/// Rows come in the order of the replicates and depend on (model, n, seed, replicate, graft) and on which
/// statistics are asked for alone, whatever the threads. Throws Interrupted when cancelled.
struct TreeBatch {
  Model model;
  Size n;
  std::uint64_t seed;
  unsigned threads;
  bool graft;  ///< of tables; trees that are written are always grown whole
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::function<void(double done, double total)> progress = {};  ///< in trees, by any thread; may be empty

  /// Throws Error where so many trees would not fit into memory, as a table of statistics or as text; says
  /// what would.
  void require_memory(const StatisticSet& statistics, std::uint64_t count) const;
  void require_memory(TreeFormat format, std::uint64_t count) const;

  /// model,n,seed,replicate, then the chosen statistics of replicates first..last-1.
  Table table(const StatisticSet& statistics, std::uint64_t first, std::uint64_t last,
              const Cancellation& cancellation) const;

  /// The trees themselves: those of the table without grafts, each with a name that says which it is.
  std::vector<RecordedTree> grown(std::uint64_t first, std::uint64_t last,
                                  const Cancellation& cancellation) const;

  /// The same as a text.
  /// @param format  one of written_formats()
  std::string trees(TreeFormat format, std::uint64_t first, std::uint64_t last,
                    const Cancellation& cancellation) const;
};

}  // namespace ramify
