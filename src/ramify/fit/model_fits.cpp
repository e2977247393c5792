#include "ramify/fit/model_fits.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/fit/count_fit.hpp"
#include "ramify/fit/limiting_ratio.hpp"
#include "ramify/fit/nested_test.hpp"
#include "ramify/fit/note.hpp"
#include "ramify/fit/tree_fit.hpp"
#include "ramify/fit/valley.hpp"
#include "ramify/measure/tree_measurement.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

constexpr double few_nodes = 100;  // of a tree: docs/validation.md
constexpr Size smallest_n = 20;    // below, counts above the tips are too few for a density

/// Throws Error where counts tell too little.
void require_counts(const OrderCounts& table) {
  if (table.contradiction) throw *table.contradiction;
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
  if (!fit.converged) return fit;
  fitter.settle(fit, counts);
  fit.horton_ratio = limiting_ratio(fit);
  add_note(fit.note, valley_note(fit));
  if (options.valleys && family.mirror == Mirror::exchanged) fitter.trace_valley(fit, counts);
  if (options.bootstrap_trees > 0) fitter.bootstrap(fit, counts, {options.bootstrap_trees, options.seed});
  return fit;
}

/// A name that begins with its file, without the folder that this lies in and what it ends on.
std::string short_name(std::string_view name, std::string_view file) {
  const bool begins = name.starts_with(file);
  return std::filesystem::path(begins ? file : name).stem().string() +
         std::string(begins ? name.substr(file.size()) : "");
}

}  // namespace

std::string too_few_to_fit(const OrderCounts& table) {
  if (table.counts.front() > smallest_n && table.counts.size() >= 3) return {};
  return fmt::format("{} tips, {} orders", table.counts.front(), table.counts.size());
}

std::vector<const Family*> chosen_families(std::string_view names) {
  std::vector<const Family*> chosen;
  if (names == "all") {
    for (const Family& family : families()) chosen.push_back(&family);
    return chosen;
  }
  while (true) {
    const std::size_t comma = names.find(',');
    chosen.push_back(&find_family(trimmed(names.substr(0, comma))));
    if (comma == std::string_view::npos) return chosen;
    names.remove_prefix(comma + 1);
  }
}

std::vector<FittedDatum> fit_order_counts(std::span<const OrderCounts> tables, std::string_view file,
                                          const ModelFitOptions& options, const Cancellation& cancellation) {
  CountFitter fitter(options.threads, cancellation, options.density);
  std::vector<FittedDatum> data;
  double done = 0;
  const auto total = static_cast<double>(tables.size()) *
                     (static_cast<double>(options.families.size()) + (options.bootstrap_trees > 0 ? 1 : 0));
  for (const OrderCounts& table : tables) {
    require_counts(table);
    const ObservedCounts counts{table.counts};
    const std::size_t orders = counts.reading().orders;
    FittedDatum datum{short_name(table.name, file),
                      "orders",
                      counts.n(),
                      fmt::format("counts of orders 1..{} and the order", orders),
                      {}};
    for (const Family* family : options.families) {
      datum.fits.push_back(fit_counts(*family, counts, options, fitter));
      if (options.progress) options.progress(++done, total);
    }
    if (options.bootstrap_trees > 0) {
      for (const NestedPair& pair : nested_pairs(datum.fits))
        add_nested_test(pair, fitter.grown_ratios(pair, counts, {options.bootstrap_trees, options.seed}));
      if (options.progress) options.progress(++done, total);
    }
    rank(datum.fits);
    data.push_back(std::move(datum));
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
  const TreeFitOptions how{pooled, {options.bootstrap_trees, options.seed}, options.threads};
  std::vector<FittedDatum> data;
  for (TreeFit& fit : fit_trees(trees, options.families, how, cancellation)) {
    std::string used = fmt::format("the splits of {:.0f} nodes", fit.nodes);
    for (FamilyFit& family : fit.families)
      if (family.converged) family.horton_ratio = limiting_ratio(family);
    if (fit.nodes < few_nodes) used += ": few, so that estimates may be off by a third of their error";
    data.push_back({short_name(fit.name, file), "tree", static_cast<Size>(fit.nodes), std::move(used),
                    std::move(fit.families)});
  }
  return data;
}

}  // namespace ramify
