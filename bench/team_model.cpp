// What many ranks do: the hand-out of src/ramify/ranks played event by event, with block costs that are
// measured here.
//   build/bench/bench/team_model configs/full/*.toml
//   build/bench/bench/team_model bench/large_job.toml
// Of each rank count: how long the configs take one after the other, the share of time in which threads have
// nothing to do, messages a second, how busy rank 0 is with them. Costs: each cell's first block is grown,
// its tables too; a block of the cell takes as long.
#include <algorithm>
#include <queue>
#include <vector>

#include "cpu_time.hpp"
#include <fmt/format.h>

#include "ramify/config/run_config.hpp"
#include "ramify/ranks/hand_out.hpp"
#include "ramify/run/grown_block.hpp"
#include "ramify/run/plan.hpp"

namespace ramify::bench {
namespace {

// What team_bench measures (docs/cluster.md).
constexpr double service = 250e-6;  // seconds of rank 0 for an outcome: message, decoding, store, answer
constexpr double latency = 10e-6;   // of a message

constexpr Size large_tree = 10'000'000;

/// Of a block of a cell, in seconds.
struct CellCost {
  double tables;  ///< once a rank, where it has not those of the model yet
  double block;
  std::size_t model;  ///< cells of one number share tables
};

/// Both measured: tables are made, and the first block grown; of large trees one, which stands for the others
/// of its block.
/// @param place  of the job in the plan
CellCost cost_of(const GrowingJob& job, const Plan& plan, std::size_t place) {
  const Cancellation never;
  std::unique_ptr<TreeSampler> sampler;
  const auto same = std::ranges::find(plan.cells, job.model, &Cell::model);
  CellCost cost{0, 0, static_cast<std::size_t>(same - plan.cells.begin())};
  cost.tables = cpu_seconds([&] { sampler = make_tree_sampler({job.model, job.method, job.n, &never}); });
  const Block first = blocks_of(job, place).front();
  Block grown = first;
  if (job.n >= large_tree) grown.last = grown.first + 1;
  const double seconds =
      cpu_seconds([&] { grown_block(plan, grown, BlockTrees(job, grown, *sampler, never)); });
  cost.block = seconds * static_cast<double>(first.trees()) / static_cast<double>(grown.trees());
  return cost;
}

/// The blocks of a plan in the order in which they are handed out, with the cost of each.
std::vector<CellCost> items_of(const Plan& plan) {
  const std::vector<GrowingJob> jobs = jobs_of(plan);
  std::vector<CellCost> items;
  for (const std::size_t j : order_of(jobs))
    items.insert(items.end(), blocks_of(jobs[j], j).size(), cost_of(jobs[j], plan, j));
  return items;
}

/// What became of a round.
struct Round {
  double time = 0, work = 0, busy = 0;  ///< seconds: in all, of all threads on blocks, of rank 0 on messages
  std::size_t messages = 0;
};

/// Plays one round: ranks of one thread, each with a queue of what it was given; outcomes are served one by
/// one.
class Game {
 public:
  Game(const std::vector<CellCost>& items, std::size_t ranks)
      : items_(items), hand_out_(items.size(), std::vector<unsigned>(ranks, 1)), ranks_(ranks) {}

  Round play() {
    for (std::size_t rank = 0; rank < ranks_.size(); ++rank) deal(rank, 0);
    while (!arrivals_.empty()) {
      const Arrival arrival = arrivals_.top();
      arrivals_.pop();
      free_at_ = std::max(free_at_, arrival.time) + service;
      round_.busy += service;
      round_.messages += 2;
      hand_out_.done(arrival.rank);
      deal(arrival.rank, free_at_ + latency);
    }
    round_.time = free_at_;
    return round_;
  }

 private:
  struct Arrival {
    double time;
    std::size_t rank;
    bool operator>(const Arrival& other) const { return time > other.time; }
  };
  struct Rank {
    double free_at = 0;
    std::vector<bool> has_tables;
  };

  void deal(std::size_t rank, double now) {
    for (const std::size_t place : hand_out_.next(rank)) {
      Rank& one = ranks_[rank];
      const CellCost& cost = items_[place];
      double takes = cost.block;
      if (one.has_tables.size() <= cost.model) one.has_tables.resize(cost.model + 1);
      if (!one.has_tables[cost.model]) takes += cost.tables;
      one.has_tables[cost.model] = true;
      one.free_at = std::max(one.free_at, now) + takes;
      round_.work += cost.block;
      arrivals_.push({one.free_at + latency, rank});
    }
  }

  const std::vector<CellCost>& items_;
  HandOut hand_out_;
  std::vector<Rank> ranks_;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> arrivals_;
  double free_at_ = 0;
  Round round_;
};

void play(const std::vector<std::vector<CellCost>>& configs) {
  fmt::print("{:>6} {:>10} {:>8} {:>12} {:>12}\n", "ranks", "seconds", "idle", "messages/s", "rank 0 busy");
  for (const std::size_t ranks : {1u, 2u, 10u, 100u, 1000u, 10000u}) {
    Round all;
    for (const auto& items : configs) {
      const Round round = Game(items, ranks).play();
      all.time += round.time;
      all.work += round.work;
      all.busy += round.busy;
      all.messages += round.messages;
    }
    fmt::print("{:>6} {:>10.2f} {:>6.1f} % {:>12.0f} {:>10.1f} %\n", ranks, all.time,
               100 * (1 - all.work / (all.time * static_cast<double>(ranks))),
               static_cast<double>(all.messages) / all.time, 100 * all.busy / all.time);
  }
}

void run(int argc, char** argv) {
  std::vector<std::vector<CellCost>> configs;
  std::size_t blocks = 0;
  double work = 0, longest = 0, tables = 0;
  for (int i = 1; i < argc; ++i) {
    configs.push_back(items_of(make_plan(read_run_config(argv[i]))));
    blocks += configs.back().size();
    for (const CellCost& item : configs.back()) {
      work += item.block;
      longest = std::max(longest, item.block);
      tables = std::max(tables, item.tables);
    }
  }
  fmt::print("{} configs, {} blocks, {:.0f} s of growing; longest block {:.2f} s, longest tables {:.2f} s\n",
             configs.size(), blocks, work, longest, tables);
  play(configs);
}

}  // namespace
}  // namespace ramify::bench

int main(int argc, char** argv) {
  ramify::bench::run(argc, argv);
  return 0;
}
