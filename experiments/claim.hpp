#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ramify/compare/verdict.hpp"
#include "ramify/run/run_tables.hpp"
#include "ramify/report/plot.hpp"

namespace ramify {

/// A plot of a claim and the name of its files.
struct NamedPlot {
  std::string stem;
  Plot plot;
};

/// A claim of the sources as an experiment: the catalogue number, what it says, and how finished cells decide
/// it.
///
/// A config serves a claim by naming it (`claim = "C20"`, or several: "C6 C7"); judge and plots then get the
/// cells of all configs that do. A new claim is one file here, a line in claims() and a config in
/// configs/quick and configs/full.
struct Claim {
  std::string_view id;  ///< catalogue number, "C20"
  std::string_view statement;
  std::string_view source;
  /// One verdict for every part of the claim that the cells bear on.
  std::vector<Verdict> (*judge)(const std::vector<CheckedCell>& cells);
  std::vector<NamedPlot> (*plots)(const std::vector<CheckedCell>& cells);
};

/// All claims, in the order of the catalogue.
const std::vector<Claim>& claims();

/// The claims that a config's `claim` key names; throws Error for an unknown one (nearest names given).
std::vector<const Claim*> find_claims(std::string_view ids);

Claim depth_claim();
Claim height_claim();
Claim patricia_order_claim();
Claim patricia_fill_claim();
Claim bst_order_claim();
Claim catalan_order_claim();

}  // namespace ramify
