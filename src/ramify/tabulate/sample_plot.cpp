#include "ramify/tabulate/sample_plot.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/law/law_limit.hpp"

namespace ramify {
namespace {

/// Bars of equal width; whole values are never cut, so that each bar holds as many of them.
class Bars {
 public:
  Bars(const StatisticInfo& statistic, const std::vector<double>& values)
      : is_whole_(!statistic.real), low_(std::ranges::min(values)) {
    const double range = std::ranges::max(values) - low_;
    const double wanted = std::clamp(2 * std::cbrt(static_cast<double>(values.size())), 10.0, most);
    width_ = range / wanted;
    if (is_whole_) width_ = range < most ? 1 : std::ceil(width_);
    if (width_ == 0) width_ = 1;
    last_ = std::max(0.0, std::ceil(range / width_) - 1);  // the largest real value closes the last bar
  }

  double width() const { return width_; }

  /// The middle of the bar that holds the value.
  double middle(double value) const {
    const double place = std::floor((value - low_) / width_);
    if (is_whole_) return low_ + place * width_ + (width_ - 1) / 2;
    return low_ + (std::min(place, last_) + 0.5) * width_;
  }

 private:
  static constexpr double most = 60;

  bool is_whole_;
  double low_, width_, last_;
};

std::vector<double> values_of(const Table& trees, std::string_view column) {
  std::vector<double> values;
  for (std::size_t row = 0; row < trees.rows(); ++row)
    if (const double value = trees.number(row, column); std::isfinite(value)) values.push_back(value);
  return values;
}

std::vector<PlotPoint> points_of(const std::map<double, double>& shares) {
  std::vector<PlotPoint> points;
  for (const auto& [x, y] : shares) points.push_back({x, y});
  return points;
}

/// What the exact law gives each bar that holds a tree; empty where the law is out of reach.
std::vector<PlotPoint> exact_shares(const TreeBatch& batch, const StatisticInfo& statistic, const Bars& bars,
                                    const std::map<double, double>& sampled) {
  if (!batch.model.is_split() || batch.n > law_limit(batch.model)) return {};
  const auto law = ExactMeans(batch.model, batch.n).law(statistic, batch.n);
  if (!law) return {};
  std::map<double, double> shares;
  double value = law->first;
  for (const double p : law->probabilities) shares[bars.middle(value++)] += p;
  std::erase_if(shares, [&](const auto& share) { return !sampled.contains(share.first); });
  return points_of(shares);
}

}  // namespace

void require_histogram(const StatisticSet& statistics) {
  const auto& chosen = statistics.chosen();
  if (chosen.size() == 1 && chosen.front()->shape == Columns::one) return;
  throw Error("--plot of several columns", "a histogram is of one statistic with one column",
              "name one, such as --statistics height");
}

Plot sample_plot(const TreeBatch& batch, const StatisticInfo& statistic, const Table& trees) {
  const auto values = values_of(trees, statistic.name);
  std::string subtitle =
      fmt::format("n = {}; {} trees; seed {}; {}", batch.n, trees.rows(), batch.seed, statistic.convention);
  if (values.size() < trees.rows())
    subtitle += fmt::format("; {} trees have no value", trees.rows() - values.size());
  Plot plot{fmt::format("{} of {}", statistic.title(), batch.model.text()), std::move(subtitle),
            std::string(statistic.name), "share of the trees"};
  plot.whole_x = !statistic.real;
  if (values.empty()) return plot;
  const Bars bars(statistic, values);
  std::map<double, double> shares;
  for (const double value : values) shares[bars.middle(value)] += 1 / static_cast<double>(values.size());
  plot.series.push_back({"sampled", points_of(shares)});
  plot.series.back().mark = PlotSeries::Mark::bar;
  plot.series.back().bar_width = bars.width();
  if (auto law = exact_shares(batch, statistic, bars, shares); !law.empty())
    plot.series.push_back({"exact law", std::move(law)});
  return plot;
}

}  // namespace ramify
