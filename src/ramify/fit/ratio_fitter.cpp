#include "ramify/fit/ratio_fitter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ramify/fit/accepted_set.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

constexpr RatioEstimator fitted = RatioEstimator::streams_mean_ratio;

constexpr double usual = 1.959963984540054;  // of 95 % of a Gaussian

std::string parameter_of(LawEstimator estimator) {
  return fmt::format("p_{}", estimator_name(estimator));
}

std::string parameter_of(RatioEstimator estimator) {
  return estimator == fitted ? "p" : fmt::format("p_{}", estimator_name(estimator));
}

/// Gaps narrower than half a step of the grid are the noise of the quantiles: closed.
std::vector<PInterval> pieces_of(const ResponseSurface& surface, const RatioCurve& curve,
                                 RatioEstimator estimator, double observed) {
  std::vector<PInterval> pieces;
  for (const PInterval& piece : accepted_set(curve.points(), estimator, observed)) {
    const bool noise =
        !pieces.empty() && std::log(piece.low / pieces.back().high) < surface.grid_step(piece.low) / 2;
    if (noise) {
      pieces.back().high = piece.high;
    } else {
      pieces.push_back(piece);
    }
  }
  return pieces;
}

/// The ends of the accepted set fall between points of the grid: three more points in each such cell of it.
void sharpen_ends(const ResponseSurface& surface, RatioCurve& curve, RatioEstimator estimator,
                  double observed, std::uint64_t trees) {
  std::vector<ResponseRequest> requests;
  const auto points = curve.points();
  for (const PInterval& piece : pieces_of(surface, curve, estimator, observed)) {
    for (const double end : {piece.low, piece.high}) {
      const auto above =
          std::find_if(points.begin(), points.end(), [end](const auto& x) { return x.p >= end; });
      if (above == points.begin() || above == points.end() || above->p == end) continue;
      for (const double share : {0.25, 0.5, 0.75})
        requests.push_back({std::lerp((above - 1)->p, above->p, share), trees});
    }
  }
  curve.merge(surface.sample(requests));
}

/// Where the pieces of the accepted set are, if there are several or it runs into the end of the range.
std::string describe(const std::vector<PInterval>& pieces) {
  std::string note;
  if (pieces.size() > 1) {
    note = "the 95 % set is a union:";
    for (const PInterval& piece : pieces)
      note.append(fmt::format(" [{:.4g}, {:.4g}]", piece.low, piece.high));
  }
  if (!pieces.empty() && pieces.front().low <= ResponseSurface::lowest_p)
    add_note(note, fmt::format("it reaches the lowest p looked at, {}", ResponseSurface::lowest_p));
  return note;
}

/// The piece that contains p, else the hull of them all; nothing where there are none.
void set_interval(FitRow& row, const std::vector<PInterval>& pieces) {
  if (pieces.empty()) return;
  const auto home = std::find_if(pieces.begin(), pieces.end(), [&](const PInterval& piece) {
    return piece.low <= row.estimate && row.estimate <= piece.high;
  });
  const bool found = home != pieces.end();
  row.lower = found ? home->low : pieces.front().low;
  row.upper = found ? home->high : pieces.back().high;
  if (!found && pieces.size() > 1) add_note(row.note, "lower and upper are those of the hull");
}

std::string describe_range(const RatioCurve& curve, RatioEstimator estimator) {
  const auto [low, high] = std::minmax_element(
      curve.points().begin(), curve.points().end(),
      [estimator](const auto& a, const auto& b) { return a[estimator].mean < b[estimator].mean; });
  return fmt::format("out of reach: the expected ratio is {:.4g} to {:.4g} for p in [{}, 0.5]",
                     (*low)[estimator].mean, (*high)[estimator].mean, ResponseSurface::lowest_p);
}

std::string describe_undecided(const std::vector<double>& undecided) {
  if (undecided.empty()) return {};
  return fmt::format(
      "near p = {:.4g} the curve comes within its noise of the ratio: more solutions may lie there",
      undecided.front());
}

FitRow murray_row(const RatioDatum& datum) {
  const PrintedRatio b = datum.branching, d = *datum.diameter_ratio;
  FitRow row;
  row.data = datum.name;
  row.model = "murray";
  row.parameter = "murray_exponent";
  row.estimate = std::log(b.value) / std::log(d.value);
  row.note = "x in R_B = R_D^x; Murray's law is 3";
  row.observed = b.value;
  if (b.rounding > 0 && d.rounding > 0) {
    row.lower = std::log(b.value - b.rounding) / std::log(d.value + d.rounding);
    row.upper = std::log(b.value + b.rounding) / std::log(d.value - d.rounding);
    add_note(row.note, "lower and upper: the rounding of the printed ratios");
  }
  return row;
}

FitRow blank_row(const RatioDatum& datum, const ModelInfo& model) {
  FitRow row;
  row.data = datum.name;
  row.model = model.name;
  row.parameter = "p_rule";
  row.estimate = 1 / datum.ratio;
  row.estimator = estimator_name(fitted);
  row.observed = datum.ratio;
  row.n_source = "unknown";
  return row;
}

bool is_fittable(const ModelInfo& info) {
  if (info.parameters.size() != 1 || info.parameters[0].domain != Domain{0, 1} || !info.is_split)
    return false;
  const SplitFraction fraction = Model::make(info, std::array{0.5}).character().fraction;
  const auto* constant = std::get_if<ConstantFraction>(&fraction);
  return constant != nullptr && constant->scatter != Scatter::none;
}

void set_rule(FitRow& row, const ResponseSummary& at_rule) {
  row.expected_at_rule = at_rule.mean;
  row.expected_at_rule_error = at_rule.standard_error;
  row.rule_low = at_rule.low;
  row.rule_high = at_rule.high;
}

}  // namespace

const ModelInfo& require_fittable(std::string_view name) {
  for (const ModelInfo& info : models())
    if (info.name == name && is_fittable(info)) return info;
  throw Error(fmt::format("model '{}' cannot be fitted to a bifurcation ratio", name),
              "one ratio fixes one parameter: the p of patricia or dst", "use --model patricia");
}

RatioFitter::RatioFitter(FitOptions options, const Cancellation& cancellation)
    : options_(std::move(options)), cancellation_(&cancellation) {
  options_.threads = std::max(1u, options_.threads);
}

SearchEffort RatioFitter::effort(Size n) const {
  // The ratios of giants hardly differ, and each takes a tenth of a second.
  const std::uint64_t least = n < 100'000'000 ? 200 : 100;
  const std::uint64_t trees = std::clamp<std::uint64_t>(options_.nodes_per_point / n, least, 4000);
  return {trees, trees};
}

const RatioCurve& RatioFitter::grid(const ResponseSurface& surface) {
  const auto [place, is_new] = grids_.try_emplace(surface.n());
  if (is_new) {
    std::vector<ResponseRequest> requests;
    for (const double p : surface.grid()) requests.push_back({p, effort(surface.n()).grid_trees});
    place->second.merge(surface.sample(requests));
  }
  return place->second;
}

void RatioFitter::require_size(const RatioDatum& datum, Size n) const {
  if (n >= 2 && n <= largest_size) return;
  throw error_at(datum.where, fmt::format("'{}' has n = {}", datum.name, n),
                 fmt::format("sizes from 2 to {} can be fitted", largest_size),
                 "give --n, or a column portion: the size of the part to be modelled");
}

void RatioFitter::fit_estimator(const ResponseSurface& surface, RatioEstimator estimator, const FitRow& blank,
                                std::vector<FitRow>& rows) {
  RatioCurve curve = grid(surface);
  SearchEffort effort = this->effort(surface.n());
  if (estimator == fitted) effort.root_trees *= 4;
  const RootSearch search = find_roots(surface, curve, estimator, blank.observed, effort);
  if (estimator == fitted) sharpen_ends(surface, curve, estimator, blank.observed, effort.grid_trees);
  const auto pieces = pieces_of(surface, curve, estimator, blank.observed);
  FitRow row = blank;
  row.solutions = search.roots.size();
  add_note(row.note, describe(pieces));
  add_note(row.note, search.flat ? std::string() : describe_undecided(search.undecided));
  for (const CurveRoot& root : search.roots) {
    FitRow& solution = rows.emplace_back(row);
    solution.solution = static_cast<std::size_t>(&root - search.roots.data()) + 1;
    solution.status = root.converged ? FitStatus::converged : FitStatus::not_converged;
    solution.estimate = root.p;
    if (root.converged) solution.standard_error = root.standard_error;
    set_interval(solution, pieces);
  }
  if (!search.roots.empty()) return;
  row.status = search.flat ? FitStatus::undetermined : FitStatus::no_solution;
  add_note(row.note, search.flat ? "every p has this ratio at this n" : describe_range(curve, estimator));
  set_interval(row, pieces);
  rows.push_back(std::move(row));
}

void RatioFitter::fit_size(const RatioDatum& datum, const SizeChoice& size, std::vector<FitRow>& rows) {
  require_size(datum, size.n);
  const ResponseSurface surface(*options_.model, size.n, options_.seed, options_.threads, *cancellation_);
  FitRow rule = blank_row(datum, *options_.model);
  rule.n = size.n;
  rule.n_source = size.source;
  rule.note = size.note;
  const ResponseRequest at_rule{rule.estimate, 4 * effort(size.n).grid_trees};
  const ResponsePoint response = surface.sample(std::span(&at_rule, 1)).front();
  FitRow blank = rule;
  set_rule(rule, response[fitted]);
  const bool kept = rule.rule_low <= rule.observed && rule.observed <= rule.rule_high;
  add_note(rule.note, kept ? "the measured ratio is within the central 95 % of the rule's trees"
                           : "the measured ratio is outside the central 95 % of the rule's trees");
  rows.push_back(rule);
  for (std::size_t e = 0; e < ratio_estimator_count; ++e) {
    if (!datum.observed[e]) continue;
    const auto estimator = static_cast<RatioEstimator>(e);
    blank.parameter = parameter_of(estimator);
    blank.estimator = estimator_name(estimator);
    blank.observed = *datum.observed[e];
    blank.estimate = FitRow::none;
    blank.note = estimator == fitted ? size.note : std::string();
    set_rule(blank, response[estimator]);
    fit_estimator(surface, estimator, blank, rows);
  }
  fit_by_law(surface, datum, rule, rows);
}

void RatioFitter::fit_by_law(const LawRatios& laws, LawEstimator estimator, const FitRow& blank,
                             std::vector<FitRow>& rows) {
  const auto [low, high] = laws.range(estimator);
  FitRow row = blank;
  if (high - low < 1e-9) {
    const bool met = std::abs(blank.observed - low) < 1e-6;
    row.status = met ? FitStatus::undetermined : FitStatus::no_solution;
    add_note(row.note, met ? "every p has this ratio at this n" : fmt::format("every p has {:.4g}", low));
    rows.push_back(std::move(row));
    return;
  }
  const auto roots = laws.roots(estimator, blank.observed);
  row.solutions = roots.size();
  for (const LawRoot& root : roots) {
    FitRow& solution = rows.emplace_back(row);
    solution.solution = static_cast<std::size_t>(&root - roots.data()) + 1;
    solution.status = FitStatus::converged;
    solution.estimate = root.p;
    solution.standard_error = 0;
    solution.lower = std::max(root.p - usual * root.deviation, 0.0);
    solution.upper = std::min(root.p + usual * root.deviation, 0.5);
  }
  if (!roots.empty()) return;
  row.status = FitStatus::no_solution;
  add_note(row.note,
           fmt::format("out of reach: the ratio of expected counts is {:.4g} to {:.4g} for p in [{}, 0.5]",
                       low, high, ResponseSurface::lowest_p));
  rows.push_back(std::move(row));
}

void RatioFitter::fit_by_law(const ResponseSurface& surface, const RatioDatum& datum, const FitRow& rule,
                             std::vector<FitRow>& rows) {
  const LawRatios& laws = laws_
                              .try_emplace(surface.n(), *options_.model, surface.n(), surface.grid(),
                                           options_.threads, *cancellation_)
                              .first->second;
  for (std::size_t e = 0; e < law_estimator_count; ++e) {
    if (!datum.observed_by_law[e]) continue;
    const auto estimator = static_cast<LawEstimator>(e);
    FitRow blank = rule;
    blank.parameter = parameter_of(estimator);
    blank.estimator = estimator_name(estimator);
    blank.observed = *datum.observed_by_law[e];
    blank.estimate = FitRow::none;
    blank.note = "by law, nothing is sampled; lower and upper by the delta method";
    const auto [mean, deviation] = laws.at(estimator, std::min(rule.estimate, 1 - rule.estimate));
    set_rule(blank, {mean, 0, mean - usual * deviation, mean + usual * deviation});
    fit_by_law(laws, estimator, blank, rows);
  }
}

std::vector<FitRow> RatioFitter::fit(const RatioDatum& datum) {
  std::vector<FitRow> rows;
  const std::vector<SizeChoice> sizes =
      options_.n ? std::vector<SizeChoice>{{*options_.n, "user", ""}} : datum.sizes;
  for (const SizeChoice& size : sizes) fit_size(datum, size, rows);
  if (sizes.empty()) {
    FitRow rule = blank_row(datum, *options_.model);
    rule.note = "no size is printed, so there is the rule alone: give --n to fit";
    rows.push_back(std::move(rule));
  }
  if (datum.diameter_ratio) rows.push_back(murray_row(datum));
  return rows;
}

std::vector<FitRow> fit_ratio(const RatioDatum& datum, const FitOptions& options,
                              const Cancellation& cancellation) {
  return RatioFitter(options, cancellation).fit(datum);
}

}  // namespace ramify
