// C16, Theorem B.2 (Kruszewski 1996): the fill level of the p-trie of n random strings satisfies P{F_n < l}
// <= 2^l e^(-n m^l), m = min(p,1-p), so that F_n >= (1-eps) log_(1/m) n; in fact F_n / log n -> 1/log(1/m).
//
// F_n >= l exactly where a string goes through each of the 2^l nodes of level l. The bound is held against
// the exact law of the trie at every n in reach. With the bound from above, P{F_n >= l} <= n m^l (a string
// goes through the least likely node), it proves the limit: both ends of the interval go to it.
#include <cmath>

#include "claim.hpp"
#include "trie_lattice.hpp"
#include <fmt/format.h>

#include "ramify/core/cancellation.hpp"
#include "ramify/theory/depth_constant.hpp"
#include "ramify/theory/fill_level_constant.hpp"

namespace ramify {
namespace {

/// log of 2^l e^(-n m^l).
double log_trie_fill_bound(double n, double smaller, double level) {
  return level * std::log(2.0) - n * std::pow(smaller, level);
}

constexpr double rounding_of_ratios = 1e-9;

/// The largest log P(F_n < l) / bound over all n and l.
Basis worst_of_fill_bound(double p, const Cancellation& cancellation) {
  constexpr Size largest = 1024;
  constexpr double least = 1e-200;  // what lies below was cut off
  const double smaller = std::min(p, 1 - p);
  double worst = -HUGE_VAL;
  Size worst_n = 0, worst_level = 0;
  std::vector<double> not_full(largest + 1);  // to level 0: without a string alone
  not_full[0] = 1;
  for (Size level = 1; std::log2(double{largest}) >= static_cast<double>(level); ++level) {
    if (cancellation.requested()) throw Interrupted();
    not_full = not_full_to_next(not_full, p);
    for (Size n = 1; n <= largest; ++n) {
      if (not_full[n] < least) continue;
      const double excess = std::log(not_full[n]) -
                            log_trie_fill_bound(static_cast<double>(n), smaller, static_cast<double>(level));
      if (excess <= worst) continue;
      worst = excess;
      worst_n = n;
      worst_level = level;
    }
  }
  return {EvidenceKind::exact,
          Standing::proved,
          worst,
          {worst - rounding_of_ratios, worst + rounding_of_ratios},
          static_cast<double>(largest),
          fmt::format(
              "largest log of exact P(F_n < l) over its bound, every n from 1 to {} and every l <= log2 n: "
              "at n = {}, l = {}",
              largest, worst_n, worst_level),
          ""};
}

/// The least and the largest F_n but for a chance of 1/500, by the two bounds.
Interval fill_levels_left(double n, double p) {
  constexpr double chance = 1e-3;
  const double smaller = std::min(p, 1 - p);
  double level = 0;
  while (log_trie_fill_bound(n, smaller, level + 1) <= std::log(chance)) ++level;
  return {level, std::floor((std::log(n) - std::log(chance)) / -std::log(smaller))};
}

/// F_n / log n at n = 10^300.
Basis between_trie_bounds(double p) {
  constexpr double n = 1e300;
  const double log_n = std::log(n);
  const auto [level, highest] = fill_levels_left(n, p);
  return {
      EvidenceKind::limit,
      Standing::proved,
      (level + highest) / (2 * log_n),
      {level / log_n, highest / log_n},
      n,
      fmt::format("{} <= F_n <= {} at n = {:g} but for a chance of 2/1000, by 2^l e^(-n m^l) and n m^l; both "
                  "over log n go to the theory as n grows",
                  level, highest, n),
      ""};
}

Statement trie_fill_bound(std::size_t number, double p) {
  return {fmt::format("C16.{}", number),
          fmt::format("log P(F_n < l) - log(2^l e^(-n m^l)) <= 0, trie({:g})", p),
          "K96 Theorem B.2",
          "deepest full level of the trie of n strings, root at level 0",
          Relation::at_most,
          "0",
          0,
          {},
          std::nullopt};
}

Statement trie_fill_limit(std::size_t number, double p) {
  const Model patricia = Model::parse(fmt::format("patricia({})", p));
  const Constant constant = fill_level_constant(patricia).value();
  return {fmt::format("C16.{}", number),
          fmt::format("F_n ~ log(n)/log(1/m), trie({:g})", p),
          "K96 B.3, Theorem B.2",
          "deepest full level of the trie of n strings, root at level 0",
          Relation::equals,
          constant.formula,
          constant.value,
          {{"1/h, the depth", depth_constant(patricia).value().value},
           {"1/log(1/(1-m)), the longest path", -1 / std::log1p(-std::min(p, 1 - p))}},
          std::nullopt};
}

/// F_n/log n between its two bounds closes in on the constant.
std::vector<NamedPlot> fill_levels_closing_in(const Evidence&) {
  Plot plot{"Fill level of random tries",
            "bars: what two bounds leave of F_n but for a chance of 1/500; dashed: 1/log(1/m)",
            "log10 of n (strings)", "F_n / log n"};
  for (const auto& [name, p] :
       {std::pair{"p = 1/2.74", 1 / 2.74}, std::pair{"p = 0.23", 0.23}, std::pair{"p = 1/4.8", 1 / 4.8}}) {
    PlotSeries series{name};
    const double limit = -1 / std::log(p);
    for (int power = 10; power <= 300; power += 10) {
      const double n = std::pow(10.0, power);
      const auto [lower, upper] = fill_levels_left(n, p);
      series.points.push_back({static_cast<double>(power), (lower + upper) / (2 * std::log(n)),
                               (upper - lower) / (2 * std::log(n))});
      series.guide.push_back({static_cast<double>(power), limit});
    }
    plot.series.push_back(std::move(series));
  }
  return {{"C16_trie_fill", std::move(plot)}};
}

}  // namespace

Claim trie_fill_claim() {
  std::vector<ClaimPart> parts;
  for (const double p : {0.5, 1 / 2.74, 0.23, 1 / 4.8})
    parts.push_back(part_without_trees(trie_fill_bound(parts.size() + 1, p), [p](const Evidence& evidence) {
      return worst_of_fill_bound(p, evidence.cancellation);
    }));
  for (const double p : {1 / 2.74, 0.23, 1 / 4.8})
    parts.push_back(part_without_trees(trie_fill_limit(parts.size() + 1, p),
                                       [p](const Evidence&) { return between_trie_bounds(p); }));
  return {"C16",
          "F_n >= (1-eps) log_(1/m) n: fill level of random tries",
          "K96 Theorem B.2",
          std::move(parts),
          {},
          fill_levels_closing_in};
}

}  // namespace ramify
