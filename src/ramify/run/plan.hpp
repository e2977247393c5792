#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ramify/config/run_config.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/sample/grow_blocks.hpp"
#include "ramify/sample/sampling_method.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {

/// One cell of an experiment: so many trees of one model and one size.
struct Cell {
  Model model;
  Size n;
  std::uint64_t replicates;
};

/// What a run does: cells in the order of the config, the statistics measured in all of them and how their
/// trees are sampled, the seed.
struct Plan {
  std::uint64_t seed;
  StatisticSet statistics;
  SamplingMethod method;
  std::vector<Cell> cells;
};

Plan make_plan(const RunConfig& config);

/// The columns of a cell: all that its trees can have.
std::vector<StatisticColumn> columns_of(const Plan& plan, const Cell& cell);

/// All that a grown block depends on, a line each: version, seed, statistics, and every cell.
std::vector<std::string> described(const Plan& plan);

/// The same as one text: processes that differ in it do not work together.
std::string identity_of(const Plan& plan);

/// The growing of every cell, in their order.
std::vector<GrowingJob> jobs_of(const Plan& plan);

/// Of all cells.
std::uint64_t total_trees(const Plan& plan);

/// What a plan costs before it is started.
struct WorkEstimate {
  double nodes;      ///< internal nodes that are grown, those of grafted subtrees left out
  double minutes;    ///< at 25 ns a node and thread, 60 where subtrees are grafted: a guess, not a promise
  double megabytes;  ///< peak memory, as far as it depends on the plan
};

WorkEstimate estimate_work(const Plan& plan, unsigned threads);

/// Work above this many nodes is refused without --yes.
inline constexpr double large_work = 1e13;

}  // namespace ramify
