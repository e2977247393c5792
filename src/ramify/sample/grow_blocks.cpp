#include "ramify/sample/grow_blocks.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <memory>
#include <mutex>
#include <numeric>

#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

/// The sampler that all blocks of one model and method clone.
class Prototype {
 public:
  Prototype(const GrowingJob& job, const Cancellation& cancellation)
      : order_{job.model, job.method, job.n, &cancellation} {}

  void expect(Size n) { order_.largest_n = std::max(order_.largest_n, n); }

  /// For one more thread; what it is cloned from stays until the last of them lets go.
  std::unique_ptr<TreeSampler> clone() {
    const std::lock_guard lock(mutex_);
    if (sampler_ == nullptr) sampler_ = make_tree_sampler(order_);
    ++users_;
    return sampler_->clone();
  }

  void let_go() {
    const std::lock_guard lock(mutex_);
    if (--users_ == 0) sampler_.reset();
  }

 private:
  SamplerOrder order_;
  std::mutex mutex_;  // guards all below
  std::size_t users_ = 0;
  std::unique_ptr<TreeSampler> sampler_;
};

/// A thread's sampler, kept while its blocks have the same prototype.
class Worker {
 public:
  TreeSampler& sampler(Prototype& prototype) {
    if (cloned_ == &prototype) return *sampler_;
    auto clone = prototype.clone();
    if (cloned_ != nullptr) cloned_->let_go();
    cloned_ = &prototype;
    sampler_ = std::move(clone);
    return *sampler_;
  }

 private:
  Prototype* cloned_ = nullptr;
  std::unique_ptr<TreeSampler> sampler_;
};

constexpr double block_nodes = 0x1p20;
/// Of a job: what one process can take in from 10^4 (docs/cluster.md).
constexpr std::uint64_t most_blocks = 1 << 15;

/// Grown nodes of a tree of a job.
double tree_nodes(const GrowingJob& job) {
  return std::max(1.0, GraftRule(job.model, job.method).grown_nodes(job.n));
}

/// Whether trees of both are grafted from the same tables.
bool share_tables(const GrowingJob& job, const GrowingJob& other) {
  return other.method == job.method && other.model == job.model;
}

/// All blocks of jobs, and what grows them.
class BlockGrower {
 public:
  BlockGrower(const std::vector<GrowingJob>& jobs, unsigned threads, const Cancellation& cancellation)
      : jobs_(jobs), cancellation_(cancellation), prototype_of_job_(jobs.size()), workers_(threads) {
    const GrowingJob* before = nullptr;
    for (const std::size_t j : order_of(jobs)) {
      if (before == nullptr || !share_tables(*before, jobs[j]))
        prototypes_.emplace_back(jobs[j], cancellation);
      before = &jobs[j];
      prototypes_.back().expect(jobs[j].n);
      prototype_of_job_[j] = &prototypes_.back();
      std::ranges::move(blocks_of(jobs[j], j), std::back_inserter(blocks_));
    }
  }

  /// Places of those that are not there yet.
  std::vector<std::size_t> missing() const {
    std::vector<std::size_t> places;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      if (!jobs_[blocks_[b].job].grown.contains(blocks_[b].index)) places.push_back(b);
    return places;
  }

  const Block& block(std::size_t place) const { return blocks_[place]; }

  /// work(block, its trees)
  template <class Work>
  auto grow(std::size_t place, unsigned worker, const Work& work) {
    const Block& block = blocks_[place];
    TreeSampler& sampler = workers_[worker].sampler(*prototype_of_job_[block.job]);
    return work(block, BlockTrees(jobs_[block.job], block, sampler, cancellation_));
  }

 private:
  const std::vector<GrowingJob>& jobs_;
  const Cancellation& cancellation_;
  std::deque<Prototype> prototypes_;  // they do not move
  std::vector<Prototype*> prototype_of_job_;
  std::vector<Block> blocks_;
  std::vector<Worker> workers_;
};

}  // namespace

std::vector<Block> blocks_of(const GrowingJob& job, std::size_t job_number) {
  const auto million = static_cast<std::uint64_t>(
      std::clamp(block_nodes / tree_nodes(job), 1.0, static_cast<double>(job.most_trees)));
  const std::uint64_t size = std::max(million, (job.last - job.first + most_blocks - 1) / most_blocks);
  std::vector<Block> blocks;
  for (std::uint64_t first = job.first; first < job.last; first += size)
    blocks.push_back({job_number, first, std::min(first + size, job.last), blocks.size()});
  return blocks;
}

std::vector<std::size_t> order_of(const std::vector<GrowingJob>& jobs) {
  const auto first_of_its_tables = [&jobs](const GrowingJob& job) {
    return std::ranges::find_if(jobs, [&job](const GrowingJob& other) { return share_tables(job, other); });
  };
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t j) {
    return std::pair(first_of_its_tables(jobs[j]), -std::max(block_nodes, tree_nodes(jobs[j])));
  });
  return order;
}

void grow_blocks(const std::vector<GrowingJob>& jobs, const Workforce& workforce,
                 const Cancellation& cancellation, const SharedBlockWork& work) {
  BlockGrower grower(jobs, workforce.threads, cancellation);
  share({work.identity, grower.missing(),
         [&](std::size_t place, unsigned worker) { grower.grow(place, worker, work.keep); },
         [&](std::size_t place, unsigned worker) { return grower.grow(place, worker, work.send); },
         [&](std::size_t place, const Bytes& outcome) { work.take(grower.block(place), outcome); }},
        workforce, cancellation);
}

void grow_blocks(const std::vector<GrowingJob>& jobs, unsigned threads, const Cancellation& cancellation,
                 const BlockWork& work) {
  grow_blocks(jobs, Workforce(threads), cancellation, {{}, work, {}, {}});
}

}  // namespace ramify
