#include "ramify/fit/model_fits.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/find_named.hpp"
#include "ramify/fit/count_fit.hpp"
#include "ramify/fit/limiting_ratio.hpp"
#include "ramify/fit/nested_test.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/fit/order_count_fit.hpp"
#include "ramify/fit/order_fit.hpp"
#include "ramify/fit/simulated_counts.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/fit/valley.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

constexpr double few_nodes = 100;             // of a tree: docs/validation.md
constexpr std::string_view linear_interval =  // docs/validation.md
    "the interval of horton_ratio is too narrow: it held the ratio eight times of ten where n was 579";
constexpr Size smallest_n = 20;  // below, counts above the tips are too few for a density

/// Throws Error where counts tell too little.
void require_counts(const OrderCounts& table) {
  if (table.contradiction) throw Error(*table.contradiction);
  const std::string few = too_few_to_fit(table);
  if (few.empty()) return;
  throw Error(fmt::format("{}: {}", table.name, few),
              fmt::format("a fit to counts takes {} tips and 3 orders at least", smallest_n + 1),
              "fit the tree itself, from a file of it");
}

/// A fit that could not be made.
FamilyFit no_fit(const Family& family, std::string reason, Size n) {
  FamilyFit fit = without_fit(family, static_cast<double>(n));
  fit.note = std::move(reason);
  return fit;
}

/// How it was simulated, and what the estimate errs by for that.
std::string simulation_note(const FamilyFit& fit, Size n) {
  constexpr double of_reading = 1.5;  // in errors of a mean: several places are read together
  const std::uint64_t trees = simulated_trees(n);
  std::string note = fmt::format("no law: simulated by {} trees of {} nodes at every place", trees,
                                 size_with_tips_of(*fit.family, n));
  if (fit.converged && !std::isnan(fit.parameters[0].standard_error))
    note +=
        fmt::format(", by which the estimate errs by some {:.1g}",
                    of_reading * fit.parameters[0].standard_error / std::sqrt(static_cast<double>(trees)));
  return note;
}

FamilyFit fit_counts(const Family& family, const ObservedCounts& counts, const ModelFitOptions& options,
                     CountFitter& fitter) {
  if (const std::string reason = CountFitter::cannot_fit(family, counts.n()); !reason.empty())
    return no_fit(family, reason, counts.n());
  const std::size_t used = counts.reading().orders;
  if (used < family.parameters.size())
    return no_fit(
        family,
        fmt::format("{} order above the tips has an order below of {} streams or more; {} are needed", used,
                    ObservedCounts::enough, family.parameters.size()),
        counts.n());
  FamilyFit fit = fitter.fit(family, counts);
  if (family.is_simulated()) add_note(fit.note, simulation_note(fit, counts.n()));
  if (!fit.converged) return fit;
  fitter.settle(fit, counts);
  fit.horton_ratio = limiting_ratio(fit);
  add_note(fit.note, valley_note(fit));
  if (options.valleys && family.mirror == Mirror::exchanged) fitter.trace_valley(fit, counts);
  if (fit.horton_ratio && family.parameters.size() > 1) add_note(fit.note, linear_interval);
  if (options.bootstrap_trees > 0) fitter.bootstrap(fit, counts, {options.bootstrap_trees, options.seed});
  return fit;
}

/// A name that begins with its file, without the folder that this lies in and what it ends on.
std::string short_name(std::string_view name, std::string_view file) {
  const bool begins = name.starts_with(file);
  return std::filesystem::path(begins ? file : name).stem().string() +
         std::string(begins ? name.substr(file.size()) : "");
}

/// Those whose likelihoods can be compared.
std::vector<const Family*> given(Given what, std::span<const Family* const> families) {
  std::vector<const Family*> found;
  std::ranges::copy_if(families, std::back_inserter(found),
                       [what](const Family* family) { return family->given == what; });
  return found;
}

/// A family without a law has no likelihood of whole trees: it is taken out, and listed with the reason.
std::vector<FamilyFit> take_simulated(std::vector<const Family*>& families) {
  std::vector<FamilyFit> none;
  for (const Family* family : families)
    if (family->is_simulated())
      none.push_back(no_fit(*family, "no law: simulated, from counts alone (--observable orders)", 0));
  std::erase_if(families, [](const Family* family) { return family->is_simulated(); });
  return none;
}

FittedDatum datum_of(std::string name, const ObservedCounts& counts) {
  return {std::move(name),
          "orders",
          counts.n(),
          fmt::format("counts of orders 1..{} and the order", counts.reading().orders),
          {}};
}

FittedDatum datum_given_order(std::string name, const ObservedCounts& counts) {
  const std::size_t used = orders_given_above(counts);
  return {std::move(name),
          "orders given order",
          counts.n(),
          used == 0 ? "no count"
                    : fmt::format("counts of orders 0..{} given those above, of a root of order {}", used - 1,
                                  counts.top()),
          {},
          Given::order};
}

void add_ranked(FittedDatum datum, std::vector<FittedDatum>& data) {
  rank(datum.fits);
  data.push_back(std::move(datum));
}

FamilyFit fit_counts_of_order(const Family& family, const ObservedCounts& counts,
                              const ModelFitOptions& options, const Cancellation& cancellation) {
  if (family.of_bi_orders == nullptr)
    return no_fit(family, "counts do not say which orders meet: fit the tree itself", counts.n());
  FamilyFit fit = fit_counts_given_order(counts);
  if (options.bootstrap_trees > 0 && fit.converged && !std::isnan(fit.log_likelihood))
    bootstrap_counts_given_order(fit, counts, {options.bootstrap_trees, options.seed}, options.workforce,
                                 cancellation);
  return fit;
}

FittedDatum tree_given_order(TreeFit fit, std::string_view file) {
  return {short_name(fit.name, file),   "tree given order",
          static_cast<Size>(fit.nodes), fmt::format("the orders below {:.0f} nodes", fit.nodes),
          std::move(fit.families),      Given::order};
}

std::vector<FittedDatum> given_order(std::span<const RecordedTree> trees, std::string_view file,
                                     std::span<const Family* const> families, const TreeFitOptions& how,
                                     const Cancellation& cancellation) {
  std::vector<FittedDatum> data;
  for (TreeFit& fit : fit_trees_given_order(trees, families, how, cancellation))
    data.push_back(tree_given_order(std::move(fit), file));
  return data;
}

/// Throws Error where the only families asked for are such, and none can be fitted.
void require_a_fit(const std::vector<FittedDatum>& data) {
  for (const FittedDatum& datum : data)
    if (std::ranges::any_of(datum.fits, [](const FamilyFit& fit) { return !std::isnan(fit.log_likelihood); }))
      return;
  if (data.empty()) return;
  const FamilyFit& fit = data.front().fits.front();
  throw Error(fmt::format("{}: no fit of {}", data.front().data, fit.family->name), fit.note,
              "take a larger tree, or several pooled");
}

}  // namespace

std::string too_few_to_fit(const OrderCounts& table) {
  if (table.counts.front() > smallest_n && table.counts.size() >= 3) return {};
  return fmt::format("{} tips, {} orders", table.counts.front(), table.counts.size());
}

std::vector<const Family*> chosen_families(std::string_view names, std::span<const Family> known) {
  std::vector<const Family*> chosen;
  if (names == "all") {
    for (const Family& family : families()) chosen.push_back(&family);
    return chosen;
  }
  while (true) {
    const std::size_t comma = names.find(',');
    chosen.push_back(&find_named(known, &Family::name, trimmed(names.substr(0, comma)), "family"));
    if (comma == std::string_view::npos) return chosen;
    names.remove_prefix(comma + 1);
  }
}

std::vector<FittedDatum> fit_order_counts(std::span<const OrderCounts> tables, std::string_view file,
                                          const ModelFitOptions& options, const Cancellation& cancellation) {
  CountFitter fitter(options.workforce, cancellation, options.density);
  const auto of_size = given(Given::size, options.families), of_order = given(Given::order, options.families);
  std::vector<FittedDatum> data;
  double done = 0;
  const auto total = static_cast<double>(tables.size()) *
                     (static_cast<double>(options.families.size()) + (options.bootstrap_trees > 0 ? 1 : 0));
  const auto add = [&](FamilyFit fit, FittedDatum& datum) {
    datum.fits.push_back(std::move(fit));
    if (options.progress) options.progress(++done, total);
  };
  for (const OrderCounts& table : tables) {
    require_counts(table);
    const ObservedCounts counts{table.counts};
    FittedDatum datum = datum_of(short_name(table.name, file), counts);
    for (const Family* family : of_size) add(fit_counts(*family, counts, options, fitter), datum);
    if (options.bootstrap_trees > 0) {
      for (const NestedPair& pair : nested_pairs(datum.fits))
        add_nested_test(pair, fitter.grown_ratios(pair, counts, {options.bootstrap_trees, options.seed}));
      if (options.progress) options.progress(++done, total);
    }
    if (!of_size.empty()) add_ranked(std::move(datum), data);
    FittedDatum by_order = datum_given_order(short_name(table.name, file), counts);
    for (const Family* family : of_order)
      add(fit_counts_of_order(*family, counts, options, cancellation), by_order);
    if (!of_order.empty()) add_ranked(std::move(by_order), data);
  }
  return data;
}

std::vector<OrderCounts> order_counts_of(std::span<const RecordedTree> trees) {
  std::vector<OrderCounts> tables;
  for (const RecordedTree& tree : trees) {
    const MeasuredOrders orders = measure_orders(tree);
    tables.push_back({orders.name, 0, orders.streams, {}, {}, {}, {}, {}});
  }
  return tables;
}

std::vector<FittedDatum> fit_whole_trees(std::span<const RecordedTree> trees, std::string_view file,
                                         bool pooled, const ModelFitOptions& options,
                                         const Cancellation& cancellation) {
  const TreeFitOptions how{pooled, {options.bootstrap_trees, options.seed}, options.workforce};
  const auto of_order = given(Given::order, options.families);
  auto of_size = given(Given::size, options.families);
  const std::vector<FamilyFit> simulated = take_simulated(of_size);
  if (of_size.empty() && of_order.empty() && !simulated.empty())
    throw Error(fmt::format("{}: no fit of {}", file, simulated[0].family->name),
                "it has no law, and is fitted to counts of streams", "add --observable orders");
  std::vector<FittedDatum> data;
  for (TreeFit& fit : fit_trees(trees, of_size, how, cancellation)) {
    std::string used = fmt::format("the splits of {:.0f} nodes", fit.nodes);
    for (FamilyFit& family : fit.families)
      if (family.converged) family.horton_ratio = limiting_ratio(family);
    fit.families.insert(fit.families.end(), simulated.begin(), simulated.end());
    if (fit.nodes < few_nodes) used += ": few, so that estimates may be off by a third of their error";
    data.push_back({short_name(fit.name, file), "tree", static_cast<Size>(fit.nodes), std::move(used),
                    std::move(fit.families)});
  }
  auto by_order = given_order(trees, file, of_order, how, cancellation);
  if (of_size.empty()) {
    require_a_fit(by_order);
    return by_order;
  }
  if (!of_order.empty()) std::ranges::move(by_order, std::back_inserter(data));
  return data;
}

std::vector<FittedDatum> fit_bi_order_table(const ObservedBiOrders& observed, std::string_view file,
                                            const ModelFitOptions& options,
                                            const Cancellation& cancellation) {
  if (const auto of_size = given(Given::size, options.families); !of_size.empty())
    throw Error(fmt::format("{}: no fit of {}", file, of_size.front()->name),
                "a table of the orders that meet has the likelihood of trees grown by order alone",
                "leave --model out, or take tokunaga, ramification");
  FittedDatum datum = tree_given_order(
      fit_bi_orders(std::string(file), observed, options.families,
                    {true, {options.bootstrap_trees, options.seed}, options.workforce}, cancellation),
      file);
  if (const std::size_t trees = observed.tree_orders().size(); trees > 1)
    datum.used += fmt::format(" of {} trees", trees);
  std::vector<FittedDatum> data{std::move(datum)};
  require_a_fit(data);
  return data;
}

}  // namespace ramify
