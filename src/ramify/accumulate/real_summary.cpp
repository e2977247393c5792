#include "ramify/accumulate/real_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ramify/core/contract.hpp"

namespace ramify {

double RealSummary::mean() const {
  return std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(values_.size());
}

double RealSummary::variance() const {
  if (values_.size() < 2) return 0;
  const double centre = mean();
  double squares = 0;
  for (const double value : values_) squares += (value - centre) * (value - centre);
  return squares / static_cast<double>(values_.size() - 1);
}

std::vector<double> RealSummary::sorted() const {
  RAMIFY_EXPECTS(!values_.empty());
  std::vector<double> sorted = values_;
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

std::vector<double> RealSummary::quantiles(const std::vector<double>& levels) const {
  const auto sorted = this->sorted();
  std::vector<double> result;
  for (const double level : levels) {
    const double rank = std::ceil(level * static_cast<double>(sorted.size()));
    result.push_back(sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1]);
  }
  return result;
}

std::vector<double> RealSummary::interpolated_quantiles(const std::vector<double>& levels) const {
  const auto sorted = this->sorted();
  std::vector<double> result;
  for (const double level : levels) {
    const double place = level * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    result.push_back(std::lerp(sorted[below], sorted[above], place - static_cast<double>(below)));
  }
  return result;
}

}  // namespace ramify
