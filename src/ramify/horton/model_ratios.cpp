#include "ramify/horton/model_ratios.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ramify/accumulate/real_summary.hpp"
#include "ramify/sample/grow_blocks.hpp"

namespace ramify {
namespace {

constexpr std::uint64_t trees_of_a_block = 64;
constexpr std::uint64_t fewest_judged = 40;
constexpr double usually = 0.95;
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Of counts, which fall.
double ratio_of_counts(RatioKind kind, std::span<const double> counts) {
  return ratio_of(kind, std::vector<double>(counts.rbegin(), counts.rend()));
}

/// Largest |z| of the ratios that are judged; NaN where undefined is.
double farthest(std::span<const double> counts, std::span<const double> means,
                std::span<const double> deviations) {
  double largest = undefined;
  for (std::size_t k = 0; k + 1 < counts.size() && k < means.size(); ++k) {
    const double z = std::abs(std::log(counts[k] / counts[k + 1]) - means[k]) / deviations[k];
    if (std::isfinite(z)) largest = std::fmax(largest, z);
  }
  return largest;
}

}  // namespace

ModelRatios::ModelRatios(const Model& model, std::span<const double> counts, const ModelTrees& plan,
                         const Cancellation& cancellation)
    : law_(stream_counts(model, static_cast<Size>(counts.front()) - 1, cancellation)),
      counts_(counts.begin(), counts.end()),
      trees_(plan.trees) {
  const Size n = static_cast<Size>(counts.front()) - 1;
  const GrowingJob job{model, n, plan.seed, sampling_of_counts(n), 0, plan.trees, trees_of_a_block};
  grow_blocks({job}, plan.threads, cancellation, [&](const Block&, const BlockTrees& grown) {
    grown.each([&](std::uint64_t replicate, const TreeMeasures& measures) {
      std::size_t orders = measures.strahler + std::size_t{1};
      while (orders > 2 && static_cast<double>(measures.streams[orders - 1]) < counts_.back()) --orders;
      const auto first = measures.streams.begin();
      trees_[replicate].assign(first, first + static_cast<std::ptrdiff_t>(orders));
    });
  });
}

ModelRatio ModelRatios::by_trees(RatioKind kind, OrderRange range) const {
  RealSummary ratios;
  for (const std::vector<double>& tree : trees_)
    if (const auto orders = orders_of(range, tree))
      ratios.add(ratio_of_counts(kind, orders->of(std::span(tree))));
  return {ratios.mean(), ratios.count() < 2 ? undefined : std::sqrt(ratios.variance())};
}

ModelRatio ModelRatios::by_law(RatioKind kind, OrderSpan orders) const {
  if (orders.last >= law_.orders()) return {undefined, undefined};
  std::vector<double> rising(orders.size());
  for (std::size_t i = 0; i < rising.size(); ++i) rising[i] = law_.means[orders.last - i];
  const std::vector<double> slopes = log_slopes(kind, rising);
  std::vector<double> weights(law_.orders());
  for (std::size_t i = 0; i < rising.size(); ++i) weights[orders.last - i] = slopes[i] / rising[i];
  const double mean = ratio_of(kind, rising);
  return {mean, mean * law_.deviation(weights)};
}

double ModelRatios::pooled_means() const {
  return ratio_of_counts(RatioKind::pooled_ratio, law_.means);
}

ModelRatios::LogRatio ModelRatios::log_ratio_by_law(std::size_t k) const {
  const ModelRatio ratio = by_law(RatioKind::geometric, {k, k + 1});
  return {std::log(ratio.mean), ratio.deviation / ratio.mean};
}

std::vector<ModelRatios::LogRatio> ModelRatios::log_ratios() const {
  std::vector<RealSummary> of_orders;
  for (const std::vector<double>& tree : trees_)
    for (std::size_t k = 0; k + 1 < tree.size(); ++k) {
      if (of_orders.size() <= k) of_orders.resize(k + 1);
      of_orders[k].add(std::log(tree[k] / tree[k + 1]));
    }
  std::vector<LogRatio> found;
  for (const RealSummary& ratios : of_orders) {
    const bool judged = ratios.count() >= fewest_judged;
    found.push_back({judged ? ratios.mean() : undefined, judged ? std::sqrt(ratios.variance()) : undefined});
  }
  return found;
}

std::vector<std::size_t> ModelRatios::outlying() const {
  std::vector<double> means, deviations;
  for (const LogRatio& ratio : log_ratios()) {
    means.push_back(ratio.mean);
    deviations.push_back(ratio.deviation);
  }
  RealSummary usual_farthest;
  for (const std::vector<double>& tree : trees_) usual_farthest.add(farthest(tree, means, deviations));
  std::vector<std::size_t> found;
  if (usual_farthest.count() < fewest_judged) return found;
  const double limit = usual_farthest.interpolated_quantiles({usually}).front();
  for (std::size_t k = 0; k + 1 < counts_.size() && k < means.size(); ++k) {
    // Trees of mean counts scatter too little in the low orders: there the law is asked.
    const bool dense = k + 1 < law_.orders() && law_.means[k + 1] >= OrderSpan::many;
    const LogRatio expected = dense ? log_ratio_by_law(k) : LogRatio{means[k], deviations[k]};
    const double off = std::abs(std::log(counts_[k] / counts_[k + 1]) - expected.mean);
    if (off > limit * expected.deviation) found.push_back(k);
  }
  return found;
}

}  // namespace ramify
