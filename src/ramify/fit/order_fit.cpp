#include "ramify/fit/order_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include "ramify/fit/limiting_ratio.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/model/ramification.hpp"

namespace ramify {
namespace {

/// "p(3,1)", leaf order 0, of all orders there are.
std::string_view cell_name(std::size_t k, std::size_t j) {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (std::size_t row = 1; row <= most_orders; ++row)
      for (std::size_t column = 0; column <= row; ++column)
        all.push_back(fmt::format("p({},{})", row, column));
    return all;
  }();
  return names[(k - 1) * (k + 2) / 2 + j];
}

/// x log(x / expected), 0 of nothing.
double surprise(double x, double expected) {
  return x == 0 ? 0 : x * std::log(x / expected);
}

/// The end, between `inner` and `outer`, of the shares p that x of so many nodes are not unlikely to have:
/// the log-likelihood, the other shares of the row in proportion, falls by rise_of_95.
double share_end(double x, double nodes, double inner, double outer) {
  const auto beyond = [=](double p) {
    return surprise(x, nodes * p) + surprise(nodes - x, nodes * (1 - p)) - rise_of_95;
  };
  if (inner == outer) return outer;
  const auto found = boost::math::tools::bisect(beyond, std::min(inner, outer), std::max(inner, outer),
                                                [](double low, double high) { return high - low < 1e-12; });
  return (found.first + found.second) / 2;
}

FittedParameter share_of(const ObservedBiOrders& observed, std::size_t k, std::size_t j) {
  constexpr double nearly = 1e-15;
  const double x = observed.count(k, j), nodes = observed.nodes(k), p = x / nodes;
  return {cell_name(k, j),
          p,
          std::sqrt(p * (1 - p) / nodes),
          x == 0 ? 0 : share_end(x, nodes, p, nearly * p),
          x == nodes ? 1 : share_end(x, nodes, p, 1 - nearly * (1 - p)),
          false,
          false};
}

/// The largest that any matrix has.
double saturated_log_likelihood(const ObservedBiOrders& observed) {
  double sum = 0;
  for (std::size_t k = 1; k <= observed.largest_order(); ++k)
    for (std::size_t j = 0; j <= k; ++j) sum += surprise(observed.count(k, j), observed.nodes(k));
  return sum;
}

/// From which order on p(k,k) is biased; nothing where none is. It is the share of a row that goes on until
/// so many streams have ended.
std::string few_streams_note(const ObservedBiOrders& observed) {
  constexpr double many = 100;  // docs/validation.md
  for (std::size_t k = 1; k <= observed.largest_order(); ++k)
    if (observed.streams(k) < many)
      return fmt::format(
          "orders from {} on have fewer than {} streams: p(k,k) is too large there, by up to half of its "
          "error",
          k, many);
  return {};
}

FamilyFit fit_matrix(const Family& family, const ObservedBiOrders& observed) {
  FamilyFit fit = without_fit(family, observed.all_nodes());
  fit.log_likelihood = saturated_log_likelihood(observed);
  fit.dependent = observed.largest_order();
  fit.note = few_streams_note(observed);
  for (std::size_t k = 1; k <= observed.largest_order(); ++k)
    for (std::size_t j = 0; j <= k; ++j) fit.parameters.push_back(share_of(observed, k, j));
  return fit;
}

Objective order_objective(const Family& family, const ObservedBiOrders& observed) {
  SearchBox box = search_box(family);
  return {family.of_bi_orders(observed), std::move(box.low), std::move(box.high)};
}

/// Row after row.
std::vector<double> shares(const ObservedBiOrders& observed) {
  std::vector<double> all;
  for (const auto& row : measured_matrix(observed)) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// Of a tree of the bootstrap the estimates, then the misfit; nothing where it could not be fitted.
std::vector<double> refitted(const Family& family, const ObservedBiOrders& observed, const Point& at) {
  if (!too_few_orders(family, observed).empty()) return {};
  if (family.of_bi_orders == nullptr) return with_misfit(shares(observed), std::nan(""));
  const Minimum best = minimise(order_objective(family, observed), at);
  if (!best.converged) return {};
  return with_misfit(family.values(best.at), 2 * (saturated_log_likelihood(observed) + best.value));
}

Model model_of(const FamilyFit& fit, const ObservedBiOrders& observed) {
  if (fit.family->of_bi_orders != nullptr) return fit.family->at(fit.estimates());
  constexpr const char* name = "ramification";
  return Model::made(*fit.family->model, name, grown_model(Ramification(measured_matrix(observed), name)));
}

}  // namespace

std::string too_few_orders(const Family& family, const ObservedBiOrders& observed) {
  if (family.of_bi_orders == nullptr)
    return observed.largest_order() >= 1 ? "" : "a tip alone has no node: order 1, 1 node, is the smallest";
  double sides = 0;
  for (std::size_t i = 1; i <= observed.largest_order(); ++i) sides += observed.side_branches(i);
  if (observed.largest_order() >= 2 && sides > 0) return {};
  return fmt::format(
      "order {}, {} side branches: a and c take order 2 (leaf order 0) and a side branch, 4 nodes at least",
      observed.largest_order(), sides);
}

RamificationMatrix measured_matrix(const ObservedBiOrders& observed) {
  RamificationMatrix matrix;
  for (std::size_t k = 1; k <= observed.largest_order(); ++k) {
    auto& row = matrix.emplace_back();
    for (std::size_t j = 0; j <= k; ++j) row.push_back(observed.count(k, j) / observed.nodes(k));
  }
  return matrix;
}

FamilyFit fit_given_order(const Family& family, const ObservedBiOrders& observed) {
  if (std::string few = too_few_orders(family, observed); !few.empty()) {
    FamilyFit none = without_fit(family, observed.all_nodes());
    none.note = std::move(few);
    return none;
  }
  if (family.of_bi_orders == nullptr) return fit_matrix(family, observed);
  FamilyFit fit = fit_family(family, order_objective(family, observed), observed.all_nodes());
  if (!fit.converged) return fit;
  const auto orders = static_cast<double>(observed.largest_order());
  fit.goodness.statistic = 2 * (saturated_log_likelihood(observed) - fit.log_likelihood);
  fit.goodness.degrees = orders * (orders + 1) / 2 - static_cast<double>(fit.parameters.size());
  fit.horton_ratio = limiting_ratio(fit);
  return fit;
}

void bootstrap_given_order(FamilyFit& fit, const ObservedBiOrders& observed, const BootstrapPlan& plan,
                           const Workforce& workforce, const Cancellation& cancellation) {
  const Family& family = *fit.family;
  const Model model = model_of(fit, observed);
  const Point at = family.of_bi_orders == nullptr ? Point{} : family.searched(fit.estimates());
  const std::vector<Size> sizes(observed.tree_orders().begin(), observed.tree_orders().end());
  for (const Size order : sizes) model.require_size(order);
  Refits refits = refitted_trees(model, sizes, observed.all_nodes(), plan, workforce, cancellation,
                                 [&](std::span<const RecordedTree* const> trees) {
                                   ObservedBiOrders grown;
                                   for (const RecordedTree* tree : trees)
                                     grown.add(ObservedBiOrders(tree->tree, tree->name));
                                   return refitted(family, grown, at);
                                 });
  const std::vector<double> misfits = take_misfits(refits, plan, fit);
  if (misfits.empty()) return;
  summarise_bootstrap(refits, fit);
  if (family.of_bi_orders != nullptr) fit.goodness.p_value = bootstrap_p_value(misfits, plan.seed);
}

TreeFit fit_bi_orders(std::string name, const ObservedBiOrders& observed,
                      std::span<const Family* const> families, const TreeFitOptions& options,
                      const Cancellation& cancellation) {
  TreeFit fit{std::move(name), observed.all_nodes(), {}};
  for (const Family* family : families) {
    FamilyFit& one = fit.families.emplace_back(fit_given_order(*family, observed));
    if (options.bootstrap.trees > 0 && one.converged && !std::isnan(one.log_likelihood))
      bootstrap_given_order(one, observed, options.bootstrap, options.workforce, cancellation);
  }
  rank(fit.families);
  return fit;
}

std::vector<TreeFit> fit_trees_given_order(std::span<const RecordedTree> trees,
                                           std::span<const Family* const> families,
                                           const TreeFitOptions& options, const Cancellation& cancellation) {
  return fits_of_trees<ObservedBiOrders>(
      trees, options.pooled, [&](std::string name, const ObservedBiOrders& observed) {
        return fit_bi_orders(std::move(name), observed, families, options, cancellation);
      });
}

}  // namespace ramify
