// C15 (Devroye 1992): the fill level of a PATRICIA tree of n strings of fair bits satisfies (F_n - log2 n) /
// log2 log n -> -1, almost surely; judged in probability.
//
// Let the m = 2^l nodes of level l of the trie be cells. Where none is empty, the PATRICIA tree is full to
// level l as well: P(F_n < l) <= m (1 - 1/m)^n. Where one holds a single string, that string ends at level l
// at most: P(F_n > l) <= P(N = 0) <= 1/E N + 2/m, N the cells with one string, by Chebyshev's inequality (E
// N(N-1) <= (1 + 2/m) (E N)^2). At n = 10^300 the two leave F_n two values. Before they are believed they are
// held against the exact law at every n in reach.
#include <cmath>

#include "claim.hpp"
#include <fmt/format.h>

#include "ramify/law/bounded_law.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/statistic/fill_level.hpp"

namespace ramify {
namespace {

/// log of m (1 - 1/m)^n, m = 2^level.
double log_empty_cell(double n, double level) {
  return level * std::log(2.0) + n * std::log1p(-std::exp2(-level));
}

/// log of 1/E N + 2/m.
double log_no_single(double n, double level) {
  const double log_mean = std::log(n) + (n - 1) * std::log1p(-std::exp2(-level));
  return std::log(std::exp(-log_mean) + 2 * std::exp2(-level));
}

/// The least and the largest F_n but for a chance of 1/500.
Interval fair_levels_left(double n) {
  constexpr double chance = 1e-3;
  Interval levels{0, 0};
  while (log_empty_cell(n, levels.lower + 1) <= std::log(chance)) ++levels.lower;
  while (log_no_single(n, levels.upper) > std::log(chance)) ++levels.upper;
  return levels;
}

/// (F_n - log2 n)/log2 log n
double scaled_level(double level, double n) {
  return (level - std::log2(n)) / std::log2(std::log(n));
}

/// That at n = 10^300.
Basis between_cell_bounds() {
  constexpr double n = 1e300;
  const auto [full, least] = fair_levels_left(n);
  const double lower = scaled_level(full, n), upper = scaled_level(least, n);
  return {
      EvidenceKind::limit,
      Standing::proved,
      (lower + upper) / 2,
      {lower, upper},
      n,
      fmt::format("{} <= F_n <= {} at n = {:g} but for a chance of 2/1000, by the cells of a level that are "
                  "empty and those of one string; both bounds are log2 n - log2 log n + O(1)",
                  full, least, n),
      ""};
}

/// The largest log of P(F_n < l) over the first bound and of P(F_n > l) over the second, every n and l.
Basis worst_of_cell_bounds(const Cancellation& cancellation) {
  constexpr Size largest = 1024;
  constexpr double least = 1e-200, error = 1e-9;
  const auto law = build_law(Model::parse("patricia(1/2)"), largest,
                             BoundedLaw(FillLevel::recurrence, largest), cancellation);
  double worst = -HUGE_VAL;
  for (Size n = 1; n <= largest; ++n) {
    const auto strings = static_cast<double>(n) + 1;
    const std::vector<double> pmf = law.pmf(n);
    const auto value = [&](std::size_t i) { return static_cast<double>(BoundedLaw::lowest(n) + i); };
    double below = 0, above = 0;
    for (std::size_t i = 0; i < pmf.size(); ++i) {
      if (below > least) worst = std::max(worst, std::log(below) - log_empty_cell(strings, value(i)));
      below += pmf[i];
    }
    for (std::size_t i = pmf.size(); i-- > 0;) {
      if (above > least && value(i) > 0)
        worst = std::max(worst, std::log(above) - log_no_single(strings, value(i)));
      above += pmf[i];
    }
  }
  return {EvidenceKind::exact,
          Standing::proved,
          worst,
          {worst - error, worst + error},
          static_cast<double>(largest),
          fmt::format("largest log of an exact probability over its bound, every level and n from 1 to {}",
                      largest),
          ""};
}

constexpr const char* fill_convention =
    "deepest full level, root at level 0, external nodes counted; n strings";

Statement fair_fill_limit() {
  return {"C15.1",
          "(F_n - log2 n)/log2 log n -> -1 in probability, patricia(1/2)",
          "Devroye 1992; K96 B.3",
          fill_convention,
          Relation::equals,
          "-1",
          -1,
          {{"0, F_n - log2 n bounded", 0},
           {"-log 2, log log n to the base e", -std::log(2.0)},
           {"-1/log 2", -1 / std::log(2.0)}},
          std::nullopt};
}

Statement fair_fill_bounds() {
  return {"C15.2",
          "P(F_n < l) <= 2^l (1 - 2^-l)^n and P(F_n > l) <= 1/E N + 2^(1-l), patricia(1/2): log of the "
          "ratios <= 0",
          "derived",
          fill_convention,
          Relation::at_most,
          "0",
          0,
          {},
          std::nullopt};
}

/// Its two bounds close in on -1, and leave the rival behind.
std::vector<NamedPlot> fair_levels_closing_in(const Evidence&) {
  Plot plot{"Fill level of fair PATRICIA trees",
            "bars: what two bounds leave of F_n but for a chance of 1/500; dashed: claim and rival",
            "log10 of n", "(F_n - log2 n) / log2 log n"};
  PlotSeries bounds{"claimed: -1"}, rival{"were log log n to the base e: -0.69"};
  for (double power = 10; power <= 300; power += 10) {
    const double n = std::pow(10.0, power);
    const auto [full, least] = fair_levels_left(n);
    const double lower = scaled_level(full, n), upper = scaled_level(least, n);
    bounds.points.push_back({power, (lower + upper) / 2, (upper - lower) / 2});
    bounds.guide.push_back({power, -1});
    rival.guide.push_back({power, -std::log(2.0)});
  }
  plot.series = {std::move(bounds), std::move(rival)};
  return {{"C15_fair_fill", std::move(plot)}};
}

}  // namespace

Claim fair_fill_claim() {
  return {"C15",
          "(F_n - log2 n)/log2 log n -> -1: fill level of fair PATRICIA trees",
          "Devroye 1992; K96 B.3",
          {part_without_trees(fair_fill_limit(), [](const Evidence&) { return between_cell_bounds(); }),
           part_without_trees(
               fair_fill_bounds(),
               [](const Evidence& evidence) { return worst_of_cell_bounds(evidence.cancellation); })},
          {},
          fair_levels_closing_in};
}

}  // namespace ramify
