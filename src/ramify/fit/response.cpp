#include "ramify/fit/response.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <memory>
#include <mutex>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/parallel.hpp"
#include "ramify/model/model.hpp"
#include "ramify/sample/tree_sampler.hpp"

namespace ramify {
namespace {

constexpr std::uint64_t trees_of_block = 64;
constexpr double largest_step = 0.08;
constexpr double points_of_period = 6;

/// The trees of one request while they are grown, by several threads.
class Growth {
 public:
  Growth(SamplerOrder order, StreamKey key, std::uint64_t trees)
      : order_(std::move(order)), key_(key), values_(trees), trees_left_(trees) {}

  /// Grows the trees first..last-1. The sampler's tables are made by the first call and dropped by the last:
  /// those of a whole grid would take gigabytes.
  void grow(std::uint64_t first, std::uint64_t last) {
    std::call_once(made_, [this] { sampler_ = make_tree_sampler(order_); });
    const auto sampler = sampler_->clone();
    TreeMeasures measures;
    for (std::uint64_t replicate = first; replicate < last; ++replicate) {
      sampler->sample(order_.largest_n, key_, replicate, measures);
      values_[replicate] = ratio_values(measures);
    }
    const std::uint64_t left_before = trees_left_.fetch_sub(last - first);
    if (left_before == last - first) sampler_.reset();
  }

  std::span<const RatioValues> values() const { return values_; }

 private:
  SamplerOrder order_;
  StreamKey key_;
  std::vector<RatioValues> values_;
  std::once_flag made_;
  std::unique_ptr<TreeSampler> sampler_;
  std::atomic<std::uint64_t> trees_left_;
};

/// Trees of one request that one thread grows in one go.
struct Block {
  Growth* growth;
  std::uint64_t first;
  std::uint64_t last;
};

/// Linear interpolation between the order statistics (Hyndman and Fan 1996, type 7).
double quantile(std::span<const double> sorted, double level) {
  const double place = level * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

ResponseSummary summarise_column(std::span<double> values) {
  const double count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / count;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  std::sort(values.begin(), values.end());
  return {mean, std::sqrt(squares / (count - 1) / count), quantile(values, 0.025), quantile(values, 0.975)};
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
  const Pass pass = n_ <= largest_counted ? Pass::lean : Pass::mean_counts;
  std::deque<Growth> growths;  // Growth does not move
  std::vector<Block> blocks;
  for (const ResponseRequest& request : requests) {
    const Model model = Model::make(*model_, std::span(&request.p, 1));
    Growth& growth = growths.emplace_back(SamplerOrder{model, {pass, true}, n_, cancellation_},
                                          StreamKey{seed_, model.stream_cell(n_)}, request.trees);
    for (std::uint64_t first = 0; first < request.trees; first += trees_of_block)
      blocks.push_back({&growth, first, std::min(first + trees_of_block, request.trees)});
  }
  parallel_for(blocks.size(), threads_, [&](std::size_t b, unsigned) {
    // The sampler looks once in a million nodes, but it is a new one for every block.
    if (cancellation_->requested()) throw Interrupted();
    blocks[b].growth->grow(blocks[b].first, blocks[b].last);
  });
  std::vector<ResponsePoint> points;
  for (std::size_t i = 0; i < requests.size(); ++i)
    points.push_back({requests[i].p, requests[i].trees, summarise(growths[i].values())});
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
