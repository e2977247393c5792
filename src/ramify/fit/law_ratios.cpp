#include "ramify/fit/law_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "ramify/core/parallel.hpp"
#include "ramify/estimate/centred_slope.hpp"
#include "ramify/model/model.hpp"

namespace ramify {
namespace {

constexpr double relative_step = 1e-5;  // of a count or parameter, for central differences

double regression_of(std::span<const double> means, std::span<const double> order_tail) {
  double weights = 0, centre = 0;
  for (std::size_t k = 0; k < means.size(); ++k) {
    weights += order_tail[k];
    centre += order_tail[k] * static_cast<double>(k);
  }
  CentredSlope slope(centre / weights);
  for (std::size_t k = 0; k < means.size(); ++k)
    if (means[k] > 0 && order_tail[k] > 0)
      slope.add(static_cast<double>(k), std::log(means[k]), order_tail[k]);
  return std::exp(-slope.value());
}

StreamMeans expected_counts(const ModelInfo& model, double p, Size n, const Cancellation& cancellation) {
  return stream_means(Model::make(model, std::span(&p, 1)), n, cancellation);
}

}  // namespace

double law_ratio(LawEstimator estimator, const StreamMeans& counts) {
  if (counts.orders() < 2) return std::numeric_limits<double>::quiet_NaN();
  return estimator == LawEstimator::streams_pooled_ratio ? pooled_ratio_of_means(counts.means)
                                                         : regression_of(counts.means, counts.order_tail);
}

double law_ratio_deviation(LawEstimator estimator, const StreamCounts& counts) {
  StreamMeans moved{counts.means, counts.order_tail};
  std::vector<double> slopes(counts.orders());
  for (std::size_t k = 1; k < counts.orders(); ++k) {  // the tips do not scatter
    const double step = relative_step * counts.means[k];
    if (step == 0) continue;
    moved.means[k] = counts.means[k] + step;
    const double above = law_ratio(estimator, moved);
    moved.means[k] = counts.means[k] - step;
    slopes[k] = (above - law_ratio(estimator, moved)) / (2 * step);
    moved.means[k] = counts.means[k];
  }
  return counts.deviation(slopes);
}

LawRatios::LawRatios(const ModelInfo& model, Size n, const std::vector<double>& grid, unsigned threads,
                     const Cancellation& cancellation)
    : model_(&model), n_(n), cancellation_(&cancellation) {
  std::vector<StreamMeans> means(grid.size());
  parallel_for(grid.size(), threads,
               [&](std::size_t i, unsigned) { means[i] = expected_counts(model, grid[i], n, cancellation); });
  for (std::size_t i = 0; i < grid.size(); ++i) known_.emplace(grid[i], std::move(means[i]));
  for (std::size_t e = 0; e < law_estimator_count; ++e)
    curves_.push_back(curve(static_cast<LawEstimator>(e), grid, threads));
}

ScannedCurve LawRatios::curve(LawEstimator estimator, const std::vector<double>& grid,
                              unsigned threads) const {
  return {[this, estimator](double p) { return value(estimator, p); }, grid, {threads, cancellation_}};
}

double LawRatios::value(LawEstimator estimator, double p) const {
  if (const auto place = known_.find(p); place != known_.end()) return law_ratio(estimator, place->second);
  return law_ratio(estimator, expected_counts(*model_, p, n_, *cancellation_));
}

std::pair<double, double> LawRatios::range(LawEstimator estimator) const {
  const ScannedCurve& curve = curves_[index_of(estimator)];
  return {curve.lowest().y, curve.highest().y};
}

LawRatio LawRatios::at(LawEstimator estimator, double p) const {
  const StreamCounts counts = stream_counts(Model::make(*model_, std::span(&p, 1)), n_, *cancellation_);
  return {law_ratio(estimator, counts), law_ratio_deviation(estimator, counts)};
}

std::vector<LawRoot> LawRatios::roots(LawEstimator estimator, double observed) const {
  std::vector<LawRoot> found;
  for (const double p : curves_[index_of(estimator)].solutions(observed)) {
    const double step = 1e-3 * p;
    const double slope = (value(estimator, p + step) - value(estimator, p - step)) / (2 * step);
    found.push_back({p, at(estimator, p).deviation / std::abs(slope)});
  }
  return found;
}

}  // namespace ramify
