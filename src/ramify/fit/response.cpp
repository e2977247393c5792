#include "ramify/fit/response.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/accumulate/real_summary.hpp"
#include "ramify/core/contract.hpp"
#include "ramify/model/model.hpp"
#include "ramify/sample/grow_blocks.hpp"

namespace ramify {
namespace {

/// Of a block: the searches for a root ask for some hundred trees at a time.
constexpr std::uint64_t most_trees_of_a_block = 64;
constexpr double largest_step = 0.08;
constexpr double points_of_period = 6;

ResponseSummary summarise_column(std::span<const double> values) {
  RealSummary summary;
  for (const double value : values) summary.add(value);
  const auto band = summary.interpolated_quantiles({0.025, 0.975});
  return {summary.mean(), std::sqrt(summary.variance() / static_cast<double>(summary.count())), band[0],
          band[1]};
}

}  // namespace

std::array<ResponseSummary, ratio_estimator_count> summarise(std::span<const RatioValues> rows) {
  RAMIFY_EXPECTS(rows.size() >= 2);
  std::array<ResponseSummary, ratio_estimator_count> summary;
  std::vector<double> column(rows.size());
  for (std::size_t e = 0; e < ratio_estimator_count; ++e) {
    std::transform(rows.begin(), rows.end(), column.begin(), [e](const RatioValues& row) { return row[e]; });
    summary[e] = summarise_column(column);
  }
  return summary;
}

ResponseSurface::ResponseSurface(const ModelInfo& model, Size n, std::uint64_t seed, unsigned threads,
                                 const Cancellation& cancellation)
    : model_(&model), n_(n), seed_(seed), threads_(threads), cancellation_(&cancellation) {
  RAMIFY_EXPECTS(n >= 1 && threads >= 1);
}

std::vector<ResponsePoint> ResponseSurface::sample(std::span<const ResponseRequest> requests) const {
  std::vector<GrowingJob> jobs;
  std::vector<std::vector<RatioValues>> values;
  for (const ResponseRequest& request : requests) {
    jobs.push_back({Model::make(*model_, std::span(&request.p, 1)), n_, seed_, sampling_of_counts(n_), 0,
                    request.trees, most_trees_of_a_block});
    values.emplace_back(request.trees);
  }
  grow_blocks(jobs, threads_, *cancellation_, [&](const Block& block, const BlockTrees& trees) {
    trees.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      values[block.job][replicate] = ratio_values(measures);
    });
  });
  std::vector<ResponsePoint> points;
  for (std::size_t i = 0; i < requests.size(); ++i)
    points.push_back({requests[i].p, requests[i].trees, summarise(values[i])});
  return points;
}

double ResponseSurface::grid_step(double p) const {
  const double period = std::log(p) * std::log(p) / std::log(static_cast<double>(n_) + 1);
  return std::min(largest_step, period / points_of_period);
}

std::vector<double> ResponseSurface::grid() const {
  std::vector<double> grid{0.5};
  while (grid.back() > lowest_p)
    grid.push_back(std::max(lowest_p, grid.back() * std::exp(-grid_step(grid.back()))));
  std::reverse(grid.begin(), grid.end());
  return grid;
}

}  // namespace ramify
