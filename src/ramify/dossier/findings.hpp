#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ramify/compare/tree_comparison.hpp"
#include "ramify/core/cancellation.hpp"
#include "ramify/dossier/subject.hpp"
#include "ramify/fit/model_fits.hpp"
#include "ramify/horton/horton_laws.hpp"

namespace ramify {

/// What was found out about a subject.
struct Findings {
  std::optional<FittedDatum> fit;       ///< families, the best first; none: why_no_fit
  std::string why_no_fit;               ///< a sentence
  std::vector<const Family*> fitted;    ///< what was tried
  std::vector<const Family*> left_out;  ///< the tree is too small for them, or they are too slow for a table
  /// Horton's ratios; errors of R_B by error_families, refitted to the counts of streams.
  HortonLaws ratios;
  std::vector<const Family*> error_families;
  std::optional<Model> best;                ///< of the first family at its estimate, to six digits
  std::vector<ComparedStatistic> compared;  ///< the tree beside trees of the best; empty: why_not_compared
  std::string why_not_compared;             ///< a sentence; empty of tables, which have nothing to compare
};

/// Families that are fitted where none is named. Of a tree all; of a table of counts those of one parameter
/// and those without: two take minutes.
std::vector<const Family*> quick_families(const Subject& subject);

/// Fits and compares. Throws Interrupted. Cost of a tree of n nodes: some milliseconds a family up to n =
/// 10^4, request.bootstrap + request.replicates trees of the best, 40 ns a node and more, and horton_laws by
/// one family.
Findings find_out(const Subject& subject, const ReportRequest& request, const Cancellation& cancellation);

/// Nodes of the largest tree that trees of a model are grown beside: beyond, it takes minutes.
inline constexpr Size largest_compared = 200'000;

}  // namespace ramify
