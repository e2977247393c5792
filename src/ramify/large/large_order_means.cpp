#include "ramify/large/large_order_means.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/core/error.hpp"
#include "ramify/large/grid_series.hpp"

namespace ramify {

LargeOrderMeans::LargeOrderMeans(const SizeGrid& grid, const CompressedRows& rows, const OrderMeans& table,
                                 const LargeJoin& strahler, const Cancellation& cancellation)
    : grid_(&grid),
      strahler_(&strahler),
      orders_(static_cast<std::size_t>(std::log2(grid.leaves(grid.places() - 1))) + 1),
      nodes_(grid.places(), Values(orders_)),
      streams_(nodes_) {
  fill_from(table);
  PlacedRows placed(grid, rows);
  for (std::size_t place = grid.first_new_point(); place < grid.places(); ++place) {
    if (cancellation.requested()) throw Interrupted();
    extend(place, placed);
  }
}

void LargeOrderMeans::fill_from(const OrderMeans& table) {
  for (Size n = 0; n <= grid_->table_size(); ++n) {
    const auto nodes = table.nodes(n), streams = table.streams(n);
    const auto leaves = static_cast<double>(n + 1);
    for (std::size_t k = 0; k < std::min(orders_, nodes.size()); ++k) {
      nodes_[n][k] = nodes[k] / leaves;
      streams_[n][k] = streams[k] / leaves;
    }
  }
  for (std::size_t place = grid_->first_point(); place < grid_->first_new_point(); ++place) {
    const Stencil stencil = grid_->in_table(grid_->leaves(place));
    interpolate(nodes_, stencil, nodes_[place]);
    interpolate(streams_, stencil, streams_[place]);
  }
}

void LargeOrderMeans::extend(std::size_t place, PlacedRows& rows) {
  const double leaves = grid_->leaves(place);
  const auto& tails = strahler_->tails();
  Values nodes(orders_), streams(orders_), child(orders_), smaller(orders_ + 1), larger(orders_ + 1);
  double not_own = 0;
  for (const PlacedSplit& split : rows.row(place)) {
    const double of_smaller = split.weight * split.smaller_leaves / leaves;
    const double of_larger = split.weight * split.larger_leaves / leaves;
    not_own += split.weight * split.larger.not_own + split.larger.own * of_smaller;
    const auto add = [&](const Counts& counts, Values& sum) {
      interpolate(counts, split.smaller, child);
      for (std::size_t k = 0; k < orders_; ++k) sum[k] += of_smaller * child[k];
      interpolate(counts, split.larger.others, child);
      for (std::size_t k = 0; k < orders_; ++k) sum[k] += of_larger * child[k];
    };
    add(nodes_, nodes);
    add(streams_, streams);
    // A stream begins where both children have the order below.
    tails.interpolate(split.smaller, 0, smaller);
    Stencil all = split.larger.others;
    all.weight.back() += split.larger.own;
    tails.interpolate(all, 0, larger);
    for (std::size_t k = 1; k < orders_; ++k)
      streams[k] += split.weight * (smaller[k - 1] - smaller[k]) * (larger[k - 1] - larger[k]) / leaves;
  }
  for (std::size_t k = 1; k < orders_; ++k) {
    nodes_[place][k] = (nodes[k] + (tails.at(place, k) - tails.at(place, k + 1)) / leaves) / not_own;
    streams_[place][k] = streams[k] / not_own;
  }
  nodes_[place][0] = streams_[place][0] = 1;
}

void LargeOrderMeans::interpolate(const Counts& counts, const Stencil& stencil, Values& out) const {
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t r = 0; r < Stencil::width; ++r) {
    if (stencil.weight[r] == 0) continue;
    const double w = stencil.weight[r];
    const double* from = counts[stencil.first + r].data();
    for (std::size_t k = 0; k < orders_; ++k) out[k] += w * from[k];
  }
}

LargeOrderMeans::Values LargeOrderMeans::scaled(const Counts& counts, double leaves) const {
  Values means(orders_);
  interpolate(counts, grid_->anywhere(leaves), means);
  means.resize(std::min(orders_, static_cast<std::size_t>(std::log2(leaves)) + 1));
  for (double& mean : means) mean = std::max(0.0, mean) * leaves;
  return means;
}

}  // namespace ramify
