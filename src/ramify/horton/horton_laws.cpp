#include "ramify/horton/horton_laws.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "ramify/fit/model_fits.hpp"
#include "ramify/horton/scatter.hpp"
#include "ramify/theory/horton_ratio_constant.hpp"

namespace ramify {
namespace {

constexpr double badly = 0.001;  // chance of a misfit as large
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<double> reals(const std::vector<std::uint64_t>& counts) {
  return {counts.begin(), counts.end()};
}

/// The tree's streams as a table of one's own, from the leaf order up.
OrderCounts counts_of(const MeasuredOrders& tree) {
  return {tree.name, 1, tree.streams, {}, {}, {}, {}, {}};
}

/// Why no model of splitting trees says anything of the tree; empty where one can.
std::string no_model_for(const MeasuredOrders& tree) {
  if (const std::string few = too_few_to_fit(counts_of(tree)); !few.empty())
    return few + " are too few to fit a model to";
  const std::uint64_t nodes = std::accumulate(tree.nodes.begin(), tree.nodes.end(), std::uint64_t{0});
  if (nodes > 0 && nodes != 2 * tree.streams.front() - 1) return "the tree is not binary";
  for (std::size_t k = 0; k + 1 < tree.streams.size(); ++k)
    if (!can_follow(tree.streams[k], tree.streams[k + 1]))
      return fmt::format("no binary tree has {} streams above {}", tree.streams[k + 1], tree.streams[k]);
  return "";
}

/// The best family that could be fitted.
const FamilyFit* best_of(const std::vector<FamilyFit>& fits) {
  const auto found = std::ranges::find_if(
      fits, [](const FamilyFit& fit) { return fit.converged && !std::isnan(fit.log_likelihood); });
  return found == fits.end() ? nullptr : &*found;
}

/// Horton's laws of one tree, ratio by ratio.
class Ratios {
 public:
  Ratios(const MeasuredOrders& tree, const HortonOptions& options, const Cancellation& cancellation)
      : tree_(tree), counts_(reals(tree.streams)) {
    laws_.data = tree.name;
    laws_.reference = unknown;
    laws_.trees = 0;
    no_model_ = no_model_for(tree);
    if (no_model_.empty()) fit_model(options, cancellation);
  }

  HortonLaws take() {
    add_bifurcation();
    add_means("R_L", tree_.mean_lengths);
    add_means("R_D", tree_.mean_radii);
    add_means("R_A", tree_.mean_areas);
    add_murray();
    return std::move(laws_);
  }

 private:
  void fit_model(const HortonOptions& options, const Cancellation& cancellation) {
    const OrderCounts counts = counts_of(tree_);
    const auto fitted =
        fit_order_counts(std::span(&counts, 1), tree_.name,
                         {options.families, 0, options.trees.seed, options.trees.threads}, cancellation);
    const FamilyFit* best = best_of(fitted.front().fits);
    if (best == nullptr) {
      no_model_ = "none of the families could be fitted";
      return;
    }
    const Model model = best->family->at(best->estimates());
    laws_.model = fitted_text(*best);
    laws_.trees = options.trees.trees;
    model_.emplace(model, counts_, options.trees, cancellation);
    if (best->goodness.p_value < badly)
      misfit_ = fmt::format(
          "the model fits badly (misfit_p below {}): its errors are not those of such a tree", badly);
    const auto limit = horton_ratio_constant(model);
    laws_.reference = limit ? limit->value : model_->pooled_means();
    laws_.reference_name = limit ? "limit" : "pooled_means";
  }

  static std::string fitted_text(const FamilyFit& fit) {
    if (fit.parameters.empty()) return std::string(fit.family->name);
    std::string text(fit.family->name);
    char before = '(';
    for (const double value : fit.estimates()) {
      text += fmt::format("{}{:.5g}", before, value);
      before = ',';
    }
    return text + ')';
  }

  void add_bifurcation() {
    const std::vector<std::size_t> outlying = model_ ? model_->outlying() : std::vector<std::size_t>{};
    for (const OrderRange range : order_ranges) {
      const auto orders = orders_of(range, counts_);
      if (!orders) continue;
      for (const RatioKind kind : ratio_kinds) {
        HortonRatio ratio = bifurcation(kind, range, *orders);
        for (const std::size_t k : outlying)
          if (k >= orders->first && k < orders->last) ratio.outlying.push_back(k);
        laws_.ratios.push_back(std::move(ratio));
      }
    }
  }

  HortonRatio bifurcation(RatioKind kind, OrderRange range, OrderSpan orders) const {
    const auto read = orders.of(std::span<const double>(counts_));
    const std::vector<double> rising(read.rbegin(), read.rend());
    HortonRatio ratio = blank("R_B", kind, range, orders, ratio_of(kind, rising));
    ratio.note = range == OrderRange::all ? trunk_note() : "";
    if (!model_) {
      ratio.standard_error = ratio.value * scatter_error(kind, rising);
      ratio.error_from = ErrorSource::scatter;
      add_sentence(ratio.note, no_model_);
      return ratio;
    }
    const bool dense = range == OrderRange::dense;
    const ModelRatio expected = dense ? model_->by_law(kind, orders) : model_->by_trees(kind, range);
    ratio.standard_error = expected.deviation;
    add_sentence(ratio.note, misfit_);
    ratio.error_from = dense ? ErrorSource::law : ErrorSource::trees;
    ratio.bias = expected.mean - laws_.reference;
    return ratio;
  }

  /// Of a sequence of means, where it has any.
  void add_means(std::string_view quantity, const std::vector<double>& means) {
    if (means.empty()) return;
    const std::vector<std::size_t> outlying = off_the_line(means);
    for (const OrderRange range : order_ranges) {
      const auto orders = orders_of(range, counts_);
      if (!orders) continue;
      const auto read = orders->of(std::span(means));
      for (const RatioKind kind : ratio_kinds) {
        if (kind == RatioKind::pooled_ratio) continue;  // of counts
        HortonRatio ratio = blank(quantity, kind, range, *orders, ratio_of(kind, read));
        if (std::isnan(ratio.value)) continue;
        ratio.standard_error = ratio.value * scatter_error(kind, read);
        ratio.error_from = ErrorSource::scatter;
        ratio.note = range == OrderRange::all ? trunk_note() : "";
        for (const std::size_t k : outlying)
          if (k >= orders->first && k <= orders->last) ratio.outlying.push_back(k);
        laws_.ratios.push_back(std::move(ratio));
      }
    }
  }

  const HortonRatio* found(std::string_view quantity, const std::string& estimator) const {
    const auto place = std::ranges::find_if(laws_.ratios, [&](const HortonRatio& ratio) {
      return ratio.quantity == quantity && ratio.estimator == estimator;
    });
    return place == laws_.ratios.end() ? nullptr : &*place;
  }

  /// R_B = R_D^x, by the regressions over the same orders; then fork by fork.
  void add_murray() {
    for (const OrderRange range : order_ranges) {
      const std::string estimator = fmt::format("{}{}", name_of(RatioKind::regression), suffix_of(range));
      const HortonRatio *branching = found("R_B", estimator), *widening = found("R_D", estimator);
      if (branching == nullptr || widening == nullptr || !(widening->value > 1)) continue;
      const double log_b = std::log(branching->value), log_d = std::log(widening->value);
      HortonRatio exponent =
          blank("murray_exponent", RatioKind::regression, range, branching->orders, log_b / log_d);
      exponent.standard_error =
          exponent.value * std::hypot(branching->standard_error / branching->value / log_b,
                                      widening->standard_error / widening->value / log_d);
      exponent.error_from = ErrorSource::ratios;
      laws_.ratios.push_back(std::move(exponent));
    }
    if (tree_.murray.forks == 0) return;
    HortonRatio forks =
        blank("murray_exponent", RatioKind::regression, OrderRange::all, {0, 0}, tree_.murray.median);
    forks.estimator = "forks";
    forks.note = fmt::format(
        "median over {} forks, {} of them without an exponent: a branch is as thick as "
        "the one it springs from",
        tree_.murray.forks, tree_.murray.infinite);
    laws_.ratios.push_back(std::move(forks));
  }

  static HortonRatio blank(std::string_view quantity, RatioKind kind, OrderRange range, OrderSpan orders,
                           double value) {
    return {quantity, fmt::format("{}{}", name_of(kind), suffix_of(range)),
            orders,   value,
            unknown,  ErrorSource::none,
            unknown,  {},
            ""};
  }

  static void add_sentence(std::string& note, const std::string& sentence) {
    if (!sentence.empty()) note += note.empty() ? sentence : "; " + sentence;
  }

  /// What nobody sees in a table: that its highest order ends where the measuring did.
  std::string trunk_note() const {
    const std::uint64_t top = tree_.streams.back();
    if (top == 1) return "the one stream of the highest order may be cut: _below_top leaves it out";
    return fmt::format(
        "{} streams of the highest order: cut below where they meet, or more than one tree; _below_top "
        "leaves "
        "them out",
        top);
  }

  const MeasuredOrders& tree_;
  std::vector<double> counts_;
  HortonLaws laws_;
  std::string no_model_, misfit_;
  std::optional<ModelRatios> model_;
};

}  // namespace

std::vector<const Family*> one_parameter_families() {
  std::vector<const Family*> chosen;
  for (const Family& family : families())
    if (family.parameters.size() == 1) chosen.push_back(&family);
  return chosen;
}

std::vector<HortonLaws> horton_laws(std::span<const MeasuredOrders> trees, const HortonOptions& options,
                                    const Cancellation& cancellation) {
  std::vector<HortonLaws> all;
  for (const MeasuredOrders& tree : trees) {
    all.push_back(Ratios(tree, options, cancellation).take());
    if (options.progress)
      options.progress(static_cast<double>(all.size()), static_cast<double>(trees.size()));
  }
  return all;
}

}  // namespace ramify
