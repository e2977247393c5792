#include "growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/run/run_plots.hpp"

namespace ramify {
namespace {

/// Those that are not the theory itself, each once.
std::vector<NamedValue> distinct(std::vector<NamedValue> rivals, double theory) {
  std::vector<NamedValue> kept;
  constexpr double same = 1e-9;
  for (auto& rival : rivals) {
    const auto is_near = [&](double value) { return std::abs(rival.value - value) < same; };
    const bool is_known = is_near(theory) || std::ranges::any_of(kept, [&](const NamedValue& other) {
                            return is_near(other.value);
                          });
    if (!is_known) kept.push_back(std::move(rival));
  }
  return kept;
}

/// The line of the claimed slope through the last point.
std::vector<PlotPoint> law_through(const std::vector<PlotPoint>& means, double theory) {
  std::vector<PlotPoint> law;
  const PlotPoint& last = means.back();
  for (const auto& point : means) law.push_back({point.x, last.y + theory * std::log(point.x / last.x)});
  return law;
}

/// Points, exact curve and claimed slope of one model; the slope as it is drawn, per factor of 10, and as the
/// sources give it.
PlotSeries growth_series(const ClaimPart& part, const ModelCells& cells) {
  const double theory = part.statement.theory;
  PlotSeries series{fmt::format("{}: claimed {:.4g} log n, {:.4g} a decade", cells.model.text(), theory,
                                theory * std::numbers::ln10)};
  series.points = sampled_means(cells, *part.statistic);
  series.curve = exact_means(cells.curves, cells.model.text(), *part.statistic);
  series.guide = law_through(series.points, theory);
  series.look = cells.look;
  return series;
}

}  // namespace

std::function<Basis(const Evidence&)> growth_basis(const GrowthCase& growth) {
  return [growth](const Evidence& evidence) {
    return evidence.limits.of(growth.model, growth.ladder, evidence.cancellation);
  };
}

std::vector<ClaimPart> growth_parts(std::string_view claim, const GrowthLaw& law,
                                    const std::vector<GrowthCase>& cases) {
  std::vector<ClaimPart> parts;
  for (const GrowthCase& growth : cases) {
    const auto constant = law.constant(growth.model);
    RAMIFY_EXPECTS(constant.has_value());
    Statement statement{fmt::format("{}.{}", claim, parts.size() + 1),
                        fmt::format("{}, {}", law.statement, growth.model.text()),
                        std::string(law.source),
                        std::string(law.convention),
                        Relation::equals,
                        constant->formula,
                        constant->value,
                        distinct(law.rivals(growth.model), constant->value),
                        std::nullopt};
    parts.push_back({std::move(statement), growth.model, growth.ladder.statistic, growth_basis(growth)});
  }
  return parts;
}

std::vector<ClaimPart> growth_parts_with_grid(std::string_view claim, const GrowthLaw& law,
                                              const std::vector<const char*>& sampled, GrowthLadder ladder,
                                              double largest_of_grid) {
  std::vector<GrowthCase> cases;
  for (const char* model : sampled) cases.push_back({Model::parse(model), ladder});
  ladder.largest_n = largest_of_grid;
  for (const char* model : beta_grid) cases.push_back({Model::parse(model), ladder});
  auto parts = growth_parts(claim, law, cases);
  for (std::size_t i = sampled.size(); i < parts.size(); ++i)
    parts[i] = part_without_trees(parts[i].statement, parts[i].basis);
  return parts;
}

std::vector<PlotPoint> sampled_means(const ModelCells& model, const StatisticColumn& column) {
  std::vector<PlotPoint> means;
  for (const auto& cell : model.cells) {
    const auto& summary = cell.result.column(column);
    means.push_back({static_cast<double>(cell.result.n), summary.mean, 2 * summary.standard_error});
  }
  return means;
}

NamedPlot growth_plot(const PlotNames& names, const std::vector<ClaimPart>& parts,
                      const std::vector<ModelCells>& models) {
  Plot plot{std::string(names.title),
            "points: sampled means, two standard errors; curves: exact; dashed: the claimed slope through "
            "the last point",
            "n (internal nodes)",
            std::string(names.y_label),
            true,
            false};
  for (const ModelCells& cells : models) {
    const auto part = std::ranges::find(parts, cells.model, &ClaimPart::model);
    RAMIFY_EXPECTS(part != parts.end());
    plot.series.push_back(growth_series(*part, cells));
  }
  return {std::string(names.stem), std::move(plot)};
}

Claim growth_claim(Claim claim, const PlotNames& plot) {
  claim.plots = [parts = claim.parts, plot](const std::vector<ModelCells>& models) {
    return std::vector<NamedPlot>{growth_plot(plot, parts, models)};
  };
  return claim;
}

}  // namespace ramify
