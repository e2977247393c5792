#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/workforce.hpp"
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

/// The blocks of a job: about a million grown nodes each, so that the last of them do not leave threads idle,
/// and no more than 32,768 in all. They depend on the job alone.
std::vector<Block> blocks_of(const GrowingJob& job, std::size_t job_number);

/// The order in which jobs are begun: model by model, so that each one's tables are there once; of a model
/// those first whose trees are larger than a block, the largest before all: begun last, one would be waited
/// for.
std::vector<std::size_t> order_of(const std::vector<GrowingJob>& jobs);

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

/// What the processes of a team do with blocks (SharedWork).
struct SharedBlockWork {
  std::string identity;  ///< of jobs and statistics
  BlockWork keep;
  std::function<Bytes(const Block& block, const BlockTrees& trees)> send;
  std::function<void(const Block& block, const Bytes& outcome)> take;
};

/// The loop that grows trees: hands the blocks of all jobs that are not there yet, in order_of() the jobs, to
/// the threads of all processes.
///
/// Every replicate has a stream of its own, so a tree depends on (seed, model, n, replicate, method) alone,
/// whatever the threads, processes and blocks. What a model's trees are grafted from is computed when its
/// first block begins, for the largest of its sizes, by each process for itself, and dropped when no thread
/// works on the model: the tables of a grid of models would take gigabytes. Throws Interrupted when
/// cancelled, and what `work` throws.
void grow_blocks(const std::vector<GrowingJob>& jobs, const Workforce& workforce,
                 const Cancellation& cancellation, const SharedBlockWork& work);

/// The same by the threads of this process alone.
/// @param threads  >= 1; that many run, however few the cores
void grow_blocks(const std::vector<GrowingJob>& jobs, unsigned threads, const Cancellation& cancellation,
                 const BlockWork& work);

}  // namespace ramify
