// C8 (Kruszewski 1996, 2.5.3 to 2.5.5): mean and variance of the split. X ~ beta(a,b): E X = a/(a+b), Var X =
// ab/((a+b)^2 (a+b+1)); X binomial(n,p): np and np(1-p), where it is the n-1 nodes below the root that are
// divided.
//
// left = floor(nX) lies less than 1 below nX, so the exact law of left at one n bounds both: E X lies within
// 1/n above E left/n, and the deviation of X within 1/(2n) of that of left/n.
#include <array>
#include <cmath>
#include <numeric>

#include "claim.hpp"
#include <fmt/format.h>

#include "ramify/theory/beta_split.hpp"
#include "ramify/theory/split_mean.hpp"
#include "ramify/theory/split_variance.hpp"

namespace ramify {
namespace {

constexpr std::array moment_models{"beta(10,80)", "beta(1,5)", "beta(0.3,3)"};
constexpr Size split_size = 1 << 14;
constexpr double cutoff = 1e-30;
constexpr double law_error = 1e-9;  // relative, of the split laws (tests/exact/split_law_test.cpp)

/// Mean and standard deviation of the left size.
struct LeftSize {
  double mean, deviation;
};

LeftSize left_size(const Model& model, Size n) {
  const WeightWindow window = model.window(n, cutoff);
  double total = 0, sum = 0, squares = 0;
  const auto at = [&](std::size_t m) { return static_cast<double>(window.first + m); };
  for (std::size_t m = 0; m < window.weights.size(); ++m) {
    total += window.weights[m];
    sum += window.weights[m] * at(m);
  }
  const double mean = sum / total;
  for (std::size_t m = 0; m < window.weights.size(); ++m)
    squares += window.weights[m] * (at(m) - mean) * (at(m) - mean);
  return {mean, std::sqrt(squares / total)};
}

Basis exact_moment(double estimate, Interval interval, std::string method) {
  return {EvidenceKind::exact, Standing::proved, estimate, interval, static_cast<double>(split_size),
          std::move(method),   "larger n"};
}

Basis beta_mean(const Model& model) {
  const auto n = static_cast<double>(split_size);
  const double low = left_size(model, split_size).mean / n;
  return exact_moment(low + 0.5 / n, {low * (1 - law_error), (low + 1 / n) * (1 + law_error)},
                      "E floor(nX)/n by the exact split law, and 1/n above it");
}

Basis beta_variance(const Model& model) {
  const auto n = static_cast<double>(split_size);
  const double deviation = left_size(model, split_size).deviation / n;
  const auto variance = [&](double shift) { return (deviation + shift) * (deviation + shift); };
  return exact_moment(variance(0), {variance(-0.5 / n - law_error), variance(0.5 / n + law_error)},
                      "deviation of floor(nX)/n by the exact split law, 1/(2n) either way");
}

ClaimPart beta_part(std::string part, const Model& model, bool is_mean) {
  const auto constant = (is_mean ? split_mean(model) : split_variance(model)).value();
  const auto [a, b] = BetaSplit::of(model).value();
  const double sum = a + b;
  const std::vector<NamedValue> rivals =
      is_mean
          ? std::vector<NamedValue>{{"b/(a+b), the other side", b / sum}, {"1/2", 0.5}}
          : std::vector<NamedValue>{{"ab/(a+b)^3", a * b / (sum * sum * sum)}, {"1/12, uniform", 1 / 12.0}};
  const Statement statement{
      std::move(part),  fmt::format("{} of {}", is_mean ? "E X" : "Var X", model.text()),
      "K96 2.5.3",      "X the share of the left subtree",
      Relation::equals, constant.formula,
      constant.value,   rivals,
      std::nullopt};
  return part_without_trees(statement, [model, is_mean](const Evidence&) {
    return is_mean ? beta_mean(model) : beta_variance(model);
  });
}

/// Of the digital search tree, by exact sums: per node below the root.
ClaimPart binomial_part(std::string part, bool is_mean) {
  const Model dst = Model::parse("dst(0.23)");
  const double p = dst.parameters().front(), value = is_mean ? p : p * (1 - p);
  const auto below_root = static_cast<double>(split_size - 1);
  const Statement statement{std::move(part),
                            fmt::format("{}/(n-1) of the left size, {}", is_mean ? "E" : "Var", dst.text()),
                            "K96 2.5.5",
                            "binomial(n-1,p): the root is in neither subtree",
                            Relation::equals,
                            is_mean ? "p" : "p(1-p)",
                            value,
                            {{"binomial(n,p)", value * static_cast<double>(split_size) / below_root}},
                            std::nullopt};
  return part_without_trees(statement, [dst, is_mean, below_root](const Evidence&) {
    const auto [mean, deviation] = left_size(dst, split_size);
    const double found = (is_mean ? mean : deviation * deviation) / below_root;
    return exact_moment(found, {found * (1 - law_error), found * (1 + law_error)},
                        "summed over the exact split law");
  });
}

/// The density of the share of the left subtree by the exact law; its mean up to the curve.
PlotSeries split_density(const Model& model) {
  constexpr double least = 0.01;  // that is drawn
  constexpr Size step = split_size / 256;
  constexpr auto n = static_cast<double>(split_size);
  const WeightWindow window = model.window(split_size, cutoff);
  const double total = std::accumulate(window.weights.begin(), window.weights.end(), 0.0);
  const auto density = [&](std::size_t place) { return n * window.weights[place] / total; };
  PlotSeries series{model.text()};
  for (std::size_t place = step; place < window.weights.size(); place += step)
    if (density(place) >= least)
      series.curve.push_back({static_cast<double>(window.first + place) / n, density(place)});
  const double mean = split_mean(model).value().value;
  series.guide = {{mean, least}, {mean, density(static_cast<Size>(mean * n) - window.first)}};
  return series;
}

std::vector<NamedPlot> split_densities(const Evidence&) {
  Plot plot{"Split laws of three beta trees",
            "exact at n = 16384; dashed: the mean a/(a+b)",
            "share of the left subtree",
            "density",
            false,
            true};
  for (const char* text : moment_models) plot.series.push_back(split_density(Model::parse(text)));
  return {{"C8_splits", std::move(plot)}};
}

}  // namespace

Claim split_moments_claim() {
  std::vector<ClaimPart> parts;
  const auto next = [&] { return fmt::format("C8.{}", parts.size() + 1); };
  for (const char* text : moment_models)
    for (const bool is_mean : {true, false}) parts.push_back(beta_part(next(), Model::parse(text), is_mean));
  for (const bool is_mean : {true, false}) parts.push_back(binomial_part(next(), is_mean));
  return {"C8", "mean and variance of the split", "K96 2.5.3, 2.5.5", parts, {}, split_densities};
}

}  // namespace ramify
