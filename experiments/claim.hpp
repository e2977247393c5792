#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ramify/compare/verdict.hpp"
#include "ramify/config/run_config.hpp"
#include "ramify/io/table.hpp"
#include "ramify/model/model.hpp"
#include "ramify/report/plot.hpp"
#include "ramify/run/run_tables.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {

/// A plot of a claim and the name of its files.
struct NamedPlot {
  std::string stem;
  Plot plot;
};

/// The finished cells of one model, smallest n first, and what its plots need.
struct ModelCells {
  Model model;
  std::vector<CheckedCell> cells;
  std::vector<ExactCurve> curves = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
  std::size_t look = 0;                 ///< its symbol and colour (ModelLooks)
};

/// It is of trees of that split law.
template <class Law>
bool is_of(const Model& model) {
  return model.is_split() && std::holds_alternative<Law>(model.law());
}

/// What a claim needs of a config that serves it.
struct ClaimNeeds {
  const StatisticInfo* statistic;  ///< that it is judged by; it has one column
  std::size_t sizes;               ///< of every model, at least
  std::string_view models;         ///< what it speaks of, in words
  bool (*speaks_of)(const Model&);
};

/// A claim of the sources as an experiment: the catalogue number, what it says, what decides it and how.
///
/// Models, sizes and replicates are those of the configs that serve it (`claim = "C20"`, or several: "C6
/// C7"); judge and plots get the cells of all of them, model by model in the order of the configs. A new
/// claim is one file here, a line in claims() and a config in configs/quick and configs/full.
struct Claim {
  std::string_view id;  ///< number in docs/catalogue.md, "C20"
  std::string_view statement;
  std::string_view source;
  ClaimNeeds needs;
  /// One verdict for every part of the claim that the models bear on; every model has what `needs` says.
  std::function<std::vector<Verdict>(const std::vector<ModelCells>&)> judge;
  std::function<std::vector<NamedPlot>(const std::vector<ModelCells>&)> plots;
};

/// All claims, in the order of the catalogue.
const std::vector<Claim>& claims();

/// The claims that a config's `claim` key or --claim names, in either case, a part (C20.2) for its whole;
/// throws Error for an unknown one (nearest names given).
std::vector<const Claim*> find_claims(std::string_view ids);

/// Trees of a cell without which no claim is judged: of fewer the spread, and with it every interval, is
/// known too badly.
inline constexpr std::uint64_t claim_trees = 10;

/// The claims that a config serves. Throws Error for an unknown one, and where the config lacks what one of
/// them needs: its statistic, sizes of a model, trees of every cell, or no model but those it speaks of.
std::vector<const Claim*> served_claims(const RunConfig& config);

/// Number, statement and source of every claim: `ramify list claims`.
Table claim_table();

Claim depth_claim();
Claim height_claim();
Claim patricia_order_claim();
Claim patricia_fill_claim();
Claim bst_order_claim();
Claim catalan_order_claim();

}  // namespace ramify
