#pragma once

#include "ramify/io/table.hpp"
#include "ramify/report/plot.hpp"
#include "ramify/tabulate/tree_batch.hpp"

namespace ramify {

/// Throws Error unless one statistic with one column is asked for: that is what a histogram is of.
void require_histogram(const StatisticSet& statistics);

/// The histogram of a table of TreeBatch: which share of the trees has which value, in at most some 60 bars,
/// and the exact law over it where it is known within seconds. Trees without a value are left out, and
/// counted in the subtitle.
Plot sample_plot(const TreeBatch& batch, const StatisticInfo& statistic, const Table& trees);

}  // namespace ramify
