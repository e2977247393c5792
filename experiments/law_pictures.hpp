#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "growth.hpp"

#include "ramify/statistic/order_count.hpp"

namespace ramify {

/// Counts of the orders `lowest`, `lowest` + 1, ..., and what the ratio of neighbouring ones shall tend to.
struct OrderedCounts {
  std::string label;
  std::vector<double> counts;
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves them out
  std::optional<double> limit = {};
  std::size_t lowest = 0;
  // NOLINTEND(readability-redundant-member-init)
};

/// Expected nodes or streams of the orders 0, 1, ... of a split model at n = 10^12, as long as there are 10^4
/// streams. Throws Interrupted. Cost: 0.3 to 2 s.
std::vector<double> expected_counts(const Model& model, OrderCount::Of of, const Cancellation& cancellation);

/// The same as a series with the model's name.
OrderedCounts expected_streams(const char* model, double limit, const Cancellation& cancellation);

/// X_k/X_(k+1) against k, series by series, the limits dashed. One without counts is a level line.
NamedPlot ratio_picture(const PlotNames& names, std::string_view subtitle,
                        const std::vector<OrderedCounts>& series);

/// A model, its growth constant c, and another that somebody might believe.
struct GrowthResidual {
  Model model;
  double constant;
  std::optional<NamedValue> rival = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
};

/// Exact E X_n - c log n against n from 100 to 10^9: level, but for what oscillates, where X_n ~ c log n;
/// dashed, what a rival would make of it from n = 10^4 on. Cost: 0.5 to 3 s a model.
NamedPlot residual_picture(const PlotNames& names, const StatisticInfo& statistic,
                           const std::vector<GrowthResidual>& models);

}  // namespace ramify
