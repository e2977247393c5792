#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify {

/// Trees to grow: replicates first..last-1 of one model and size.
struct GrowingJob {
  Model model;
  Size n;
  std::uint64_t seed;
  SamplingMethod method;
  std::uint64_t first, last;
  /// Of one block at most. Fewer where a single job of small trees must keep all threads busy.
  std::uint64_t most_trees = 1024;
  /// Indices of blocks that are there already.
  std::set<std::size_t> grown = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it

  StreamKey key() const { return {seed, model.stream_cell(n)}; }
};

/// Replicates first..last-1 of a job: the unit of work.
struct Block {
  std::size_t job;
  std::uint64_t first, last;
  std::size_t index;  ///< within the job, in the order of the replicates

  std::uint64_t trees() const { return last - first; }

  friend bool operator==(const Block&, const Block&) = default;
};

/// The blocks of a job: about a million grown nodes each, so that the last of them do not leave threads idle.
/// They depend on the job alone.
std::vector<Block> blocks_of(const GrowingJob& job, std::size_t job_number);

/// The trees of a block, grown while they are looked at.
class BlockTrees {
 public:
  BlockTrees(const GrowingJob& job, const Block& block, TreeSampler& sampler,
             const Cancellation& cancellation)
      : job_(job), block_(block), sampler_(sampler), cancellation_(cancellation) {}

  /// look(replicate, measures), tree by tree in the order of the replicates. Throws Interrupted when
  /// cancelled.
  template <class Look>
  void each(Look look) const {
    const StreamKey key = job_.key();
    TreeMeasures measures;
    for (std::uint64_t replicate = block_.first; replicate < block_.last; ++replicate) {
      if (cancellation_.requested()) throw Interrupted();
      sampler_.sample(job_.n, key, replicate, measures);
      look(replicate, std::as_const(measures));
    }
  }

 private:
  const GrowingJob& job_;
  const Block& block_;
  TreeSampler& sampler_;
  const Cancellation& cancellation_;
};

/// What is done with a block; several threads call it at once, each with a block of its own.
using BlockWork = std::function<void(const Block& block, const BlockTrees& trees)>;

/// The loop that grows trees: hands the blocks of all jobs that are not there yet, in their order, to the
/// threads.
///
/// Every replicate has a stream of its own, so a tree depends on (seed, model, n, replicate, method) alone,
/// whatever the threads and the blocks. What a model's trees are grafted from is computed when its first
/// block begins, for the largest of its sizes, and dropped with its last: the tables of a grid of models
/// would take gigabytes. Throws Interrupted when cancelled, and what `work` throws.
/// @param threads  >= 1; that many run, however few the cores
void grow_blocks(const std::vector<GrowingJob>& jobs, unsigned threads, const Cancellation& cancellation,
                 const BlockWork& work);

}  // namespace ramify
