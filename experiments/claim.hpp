#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "growth_limit.hpp"

#include "ramify/compare/finding.hpp"
#include "ramify/config/run_config.hpp"
#include "ramify/io/table.hpp"
#include "ramify/model/model.hpp"
#include "ramify/report/plot.hpp"
#include "ramify/run/run_tables.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {

/// The finished cells of one model, smallest n first, and what its plots need.
struct ModelCells {
  Model model;
  std::vector<CheckedCell> cells;
  std::vector<ExactCurve> curves = {};  // NOLINT(readability-redundant-member-init): -Wextra wants it
  std::size_t look = 0;                 ///< its symbol and colour (ModelLooks)
};

/// What a claim's parts are judged with.
struct Evidence {
  GrowthLimits& limits;
  const Cancellation& cancellation;
};

/// One statement of a claim and how what is known of it is found. The statement stands before anything is
/// computed; the basis is always found, or the part named as one that cannot be judged.
struct ClaimPart {
  Statement statement;
  /// Of what trees its sampler check is; nothing, and no statistic, where the statement takes none.
  std::optional<Model> model;
  const StatisticInfo* statistic;  ///< of one column
  std::function<Basis(const Evidence&)> basis;
};

/// A part that rests on what is exact alone: no sampler is checked in its row, no config need serve it.
ClaimPart part_without_trees(Statement statement, std::function<Basis(const Evidence&)> basis);

/// A claim of the sources as an experiment: the catalogue number, what it says, its parts, and what is drawn
/// of it.
///
/// What decides a part is its basis, mostly exact laws; trees are sampled, by the configs that serve the
/// claim (`claim = "C20"`, or several: "C6 C7"), to hold the samplers against the laws, and for the plots. A
/// new claim is one file here, a line in claim.cpp and, where trees are sampled, a config in configs/quick
/// and configs/full.
struct Claim {
  std::string_view id;  ///< number in docs/catalogue.md, "C20"
  std::string_view statement;
  std::string_view source;
  std::vector<ClaimPart> parts;
  /// Of the cells of all configs that serve it, model by model in their order.
  std::function<std::vector<NamedPlot>(const std::vector<ModelCells>&)> plots;
  /// Pictures that need no trees (law_pictures.hpp); none where left out.
  // NOLINTNEXTLINE(readability-redundant-member-init): -Wextra wants it where an aggregate leaves it out
  std::function<std::vector<NamedPlot>(const Evidence&)> law_plots = {};

  bool speaks_of(const Model& model) const;
  /// False where no part takes trees: no config serves such a claim.
  bool takes_trees() const;
};

/// All claims, in the order of the catalogue. A claim is made when it is first asked for: theory values and
/// rivals of all of them take two seconds.
std::vector<const Claim*> claims();

/// Those of these numbers, likewise; what is no claim's number is passed over.
std::vector<const Claim*> claims_among(const std::function<bool(std::string_view id)>& is_wanted);

/// The claims that a config's `claim` key or --claim names, in either case, a part (C20.2) for its whole;
/// throws Error for an unknown one (nearest names given) and an unknown part.
std::vector<const Claim*> find_claims(std::string_view ids);

/// Cells of every model, and trees of a cell, without which nothing is held against the laws: of fewer the
/// spread is known too badly.
inline constexpr std::size_t claim_sizes = 4;
inline constexpr std::uint64_t claim_trees = 10;

/// The claims that a config serves. Throws Error for an unknown one, and where the config lacks what one of
/// them needs: its statistic, sizes of a model, trees of every cell, or no model but those it speaks of; and
/// for one that takes no trees.
std::vector<const Claim*> served_claims(const RunConfig& config);

/// A row for every part: `ramify list claims`.
Table claim_table();

Claim external_nodes_claim();
Claim largest_order_claim();
Claim extreme_orders_claim();
Claim stream_bounds_claim();
Claim depth_claim();
Claim height_claim();
Claim split_moments_claim();
Claim order_by_ratio_claim();
Claim fixed_split_order_claim();
Claim fixed_split_ratio_claim();
Claim first_order_claim();
Claim patricia_order_claim();
Claim trie_balance_claim();
Claim fair_fill_claim();
Claim trie_fill_claim();
Claim patricia_fill_claim();
Claim bst_fill_claim();
Claim bst_balance_claim();
Claim bst_order_claim();
Claim mean_split_order_claim();
Claim catalan_order_claim();
Claim growth_ratio_claim();
Claim lung_claim();
Claim equivalence_claim();
Claim second_law_claim();
Claim recipe_claim();

}  // namespace ramify
