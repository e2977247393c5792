#include "ramify/sample/grow_blocks.hpp"

#include <algorithm>
#include <atomic>
#include <deque>
#include <memory>
#include <mutex>

#include "ramify/core/parallel.hpp"
#include "ramify/sample/graft_rule.hpp"

namespace ramify {
namespace {

/// The sampler that all blocks of one model and method clone, while any of them are left.
class Prototype {
 public:
  Prototype(const GrowingJob& job, const Cancellation& cancellation)
      : order_{job.model, job.method, job.n, &cancellation} {}

  bool serves(const GrowingJob& job) const {
    return order_.method == job.method && order_.model == job.model;
  }

  void expect(std::size_t blocks, Size n) {
    blocks_left_ += blocks;
    order_.largest_n = std::max(order_.largest_n, n);
  }

  std::unique_ptr<TreeSampler> clone() {
    std::call_once(made_, [this] { sampler_ = make_tree_sampler(order_); });
    return sampler_->clone();
  }

  void block_done() {
    if (--blocks_left_ == 0) sampler_.reset();
  }

 private:
  SamplerOrder order_;
  std::atomic<std::size_t> blocks_left_ = 0;
  std::once_flag made_;
  std::unique_ptr<TreeSampler> sampler_;
};

/// A thread's sampler, kept while its blocks have the same prototype.
class Worker {
 public:
  TreeSampler& sampler(Prototype& prototype) {
    if (cloned_ != &prototype) sampler_ = prototype.clone();
    cloned_ = &prototype;
    return *sampler_;
  }

 private:
  const Prototype* cloned_ = nullptr;
  std::unique_ptr<TreeSampler> sampler_;
};

Prototype& prototype_of(const GrowingJob& job, std::deque<Prototype>& prototypes,
                        const Cancellation& cancellation) {
  for (Prototype& prototype : prototypes)
    if (prototype.serves(job)) return prototype;
  return prototypes.emplace_back(job, cancellation);
}

}  // namespace

std::vector<Block> blocks_of(const GrowingJob& job, std::size_t job_number) {
  const double nodes = GraftRule(job.model, job.method).grown_nodes(job.n);
  const auto size = static_cast<std::uint64_t>(
      std::clamp(0x1p20 / std::max(nodes, 1.0), 1.0, static_cast<double>(job.most_trees)));
  std::vector<Block> blocks;
  for (std::uint64_t first = job.first; first < job.last; first += size)
    blocks.push_back({job_number, first, std::min(first + size, job.last), blocks.size()});
  return blocks;
}

void grow_blocks(const std::vector<GrowingJob>& jobs, unsigned threads, const Cancellation& cancellation,
                 const BlockWork& work) {
  std::deque<Prototype> prototypes;  // they do not move
  std::vector<Prototype*> prototype_of_job(jobs.size());
  std::vector<Block> blocks;
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    auto own = blocks_of(jobs[j], j);
    std::erase_if(own, [&](const Block& block) { return jobs[j].grown.contains(block.index); });
    if (own.empty()) continue;
    prototype_of_job[j] = &prototype_of(jobs[j], prototypes, cancellation);
    prototype_of_job[j]->expect(own.size(), jobs[j].n);
    blocks.insert(blocks.end(), own.begin(), own.end());
  }
  std::vector<Worker> workers(threads);
  parallel_for(blocks.size(), threads, [&](std::size_t b, unsigned worker) {
    const Block& block = blocks[b];
    Prototype& prototype = *prototype_of_job[block.job];
    work(block, BlockTrees(jobs[block.job], block, workers[worker].sampler(prototype), cancellation));
    prototype.block_done();
  });
}

}  // namespace ramify
