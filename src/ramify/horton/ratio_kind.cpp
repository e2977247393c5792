#include "ramify/horton/ratio_kind.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "ramify/statistic/stream_geometry.hpp"

namespace ramify {
namespace {

constexpr double log_step = 1e-4;  // of log x

double pooled(std::span<const double> rising) {
  if (rising.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const double sum = std::accumulate(rising.begin(), rising.end(), 0.0);
  return (sum - rising.front()) / (sum - rising.back());
}

}  // namespace

std::string_view name_of(RatioKind kind) {
  switch (kind) {
    case RatioKind::mean_ratio:
      return "mean_ratio";
    case RatioKind::pooled_ratio:
      return "pooled_ratio";
    case RatioKind::regression:
      return "regression";
    case RatioKind::geometric:
      break;
  }
  return "geometric";
}

double ratio_of(RatioKind kind, std::span<const double> rising) {
  switch (kind) {
    case RatioKind::mean_ratio:
      return mean_ratios(rising).mean_ratio;
    case RatioKind::pooled_ratio:
      return pooled(rising);
    case RatioKind::regression:
      return mean_ratios(rising).regression;
    case RatioKind::geometric:
      break;
  }
  return mean_ratios(rising).geometric;
}

std::vector<double> log_slopes(RatioKind kind, std::span<const double> rising) {
  std::vector<double> slopes, moved(rising.begin(), rising.end());
  for (double& value : moved) {
    const double kept = value;
    value = kept * std::exp(log_step);
    const double up = ratio_of(kind, moved);
    value = kept * std::exp(-log_step);
    const double down = ratio_of(kind, moved);
    value = kept;
    slopes.push_back(std::isnan(kept) ? 0 : std::log(up / down) / (2 * log_step));
  }
  return slopes;
}

}  // namespace ramify
