// C14, Theorem B.1 and Corollary B.1 (Kruszewski 1996): the balance number of the trie of n random strings,
// which is that of their PATRICIA tree, satisfies B_n <= (1+eps) log_(1/m) n with probability to 1, m =
// min(p,1-p); with Corollary B.2, B_n / log n -> 1/log(1/m).
//
// The limit is read off the laws of B_n as that of S_n is (C13). The proof cuts the trie into zones by n q, q
// the probability of a node: a, b, c. What it says of them is counted exactly, node by node of the infinite
// trie, at every n in reach: of the two lemmas the bound of each, of which both go to 0.
//
// The ladders end at 10^20, where the limit is told to three digits. At 10^60 the fit for p = 1/2.74 gives
// 0.9920989 +- 0.0000045 and misses the constant, 0.9921049, by 1.3 of its bound: B_n drifts otherwise than
// the fitted terms.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "law_pictures.hpp"
#include "patricia.hpp"
#include "trie_lattice.hpp"
#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/theory/balance_constant.hpp"

namespace ramify {
namespace {

double log_of(Size n) {
  return std::log(static_cast<double>(n));
}

/// What a bound leaves, 0 or less where it holds; nothing to say: -infinity.
using Excess = double (*)(const TrieZoneRule& rule, const WrongOrder& wrong);

double longest_b_excess(const TrieZoneRule& rule, const WrongOrder&) {
  return static_cast<double>(trie_zone_counts(rule).longest_b) - longest_b_bound(rule);
}

/// log of |A| over (1 + log n/log(1/(1-p))) n^(1-eps).
double a_nodes_excess(const TrieZoneRule& rule, const WrongOrder&) {
  const double height = 1 - log_of(rule.n) / std::log1p(-rule.p);
  return std::log(trie_zone_counts(rule).a_nodes) - std::log(height) - (1 - rule.epsilon) * log_of(rule.n);
}

/// log of E(exceptions) over the bound of Lemma B.1, delta = e^(-2(1/2-p)^2).
double exceptions_excess(const TrieZoneRule& rule, const WrongOrder& wrong) {
  const double off_half = 0.5 - rule.p, delta = std::exp(-2 * off_half * off_half);
  const double log_bound = std::log(2.0) + std::log1p(-log_of(rule.n) / std::log1p(-rule.p)) +
                           (1 - rule.epsilon) * log_of(rule.n) -
                           (1 - delta) * std::pow(static_cast<double>(rule.n), rule.epsilon);
  return std::log(expected_exceptions(rule, wrong)) - log_bound;
}

/// log of |B*| over n^(1+eps)/p.
double b_star_excess(const TrieZoneRule& rule, const WrongOrder&) {
  return std::log(trie_zone_counts(rule).b_star_nodes) - (1 + rule.epsilon) * log_of(rule.n) +
         std::log(rule.p);
}

/// log of E(nodes of B* with more than 1 + 1/eps strings) over the bound of Lemma B.2.
double b_star_strings_excess(const TrieZoneRule& rule, const WrongOrder&) {
  const double m = std::floor(b_star_bound(rule)) + 1;
  const double log_bound = std::log(2 / rule.p) + (1 + rule.epsilon) * log_of(rule.n) -
                           m * (std::log(rule.p) + rule.epsilon * log_of(rule.n));
  return std::log(trie_zone_counts(rule).b_star_above) - log_bound;
}

/// Every n to `each`, doubled from there to `largest`.
std::vector<Size> zone_sizes(Size each, Size largest) {
  std::vector<Size> sizes;
  for (Size n = 2; n <= largest; n = n < each ? n + 1 : 2 * n) sizes.push_back(n);
  return sizes;
}

constexpr std::array zone_probabilities{1 / 2.74, 0.23, 1 / 4.8};
constexpr std::array zone_epsilons{0.2, 0.35, 0.5};

/// The largest excess over sizes, p and epsilon.
Basis worst_zone_excess(Excess excess, const std::vector<Size>& sizes, Size with_order,
                        const Cancellation& cancellation) {
  double worst = -HUGE_VAL;
  TrieZoneRule where{};
  for (const double p : zone_probabilities) {
    const WrongOrder wrong(p, with_order);
    for (const double epsilon : zone_epsilons)
      for (const Size n : sizes) {
        if (cancellation.requested()) throw Interrupted();
        const TrieZoneRule rule{n, p, epsilon};
        const double value = excess(rule, wrong);
        if (value <= worst) continue;
        worst = value;
        where = rule;
      }
  }
  constexpr double error = 1e-9;
  return {EvidenceKind::exact,
          Standing::proved,
          worst,
          {worst - error, worst + error},
          static_cast<double>(sizes.back()),
          fmt::format(
              "largest over n = {}, {}, ..., {:.3g}, p = 1/2.74, 0.23, 1/4.8, epsilon = 0.2, 0.35, 0.5: at n "
              "= {}, p = {:.4g}, epsilon = {}",
              sizes[0], sizes[1], static_cast<double>(sizes.back()), where.n, where.p, where.epsilon),
          ""};
}

/// A bound of the proof: what it bounds minus the bound is 0 at most.
ClaimPart zone_part(std::size_t number, const char* text, const char* source, Excess excess) {
  Statement statement{fmt::format("C14.{}", number),
                      text,
                      source,
                      "zones by n q: a from n^eps, c to n^-eps, b between; p < 1/2",
                      Relation::at_most,
                      "0",
                      0,
                      {},
                      std::nullopt};
  const bool takes_order = excess == exceptions_excess;
  return part_without_trees(std::move(statement), [excess, takes_order](const Evidence& evidence) {
    constexpr Size each = 200, largest = 4096, largest_without = Size{1} << 50;
    return worst_zone_excess(excess, zone_sizes(each, takes_order ? largest : largest_without),
                             takes_order ? largest : 0, evidence.cancellation);
  });
}

/// Ladders to 10^20, 4 s each.
std::vector<GrowthCase> balance_cases() {
  using Rungs = GrowthLadder::Rungs;
  using Approach = GrowthLadder::Approach;
  constexpr double largest = 1e20;
  std::vector<GrowthCase> cases;
  for (const char* model : {"patricia(1/2)", "patricia(1/2.74)", "patricia(0.23)"})
    cases.push_back({Model::parse(model), {&statistic::balance, Rungs::medians, Approach::drifts, largest}});
  return cases;
}

/// The growth of B_n, of trees that no config samples.
std::vector<ClaimPart> balance_growth_parts() {
  const GrowthLaw law{"K96 Theorem B.1, Corollary B.2", "B_n ~ log(n)/log(1/p)",
                      "most edges to a smaller-or-equal child on a path", balance_constant,
                      rival_patricia_orders};
  constexpr double largest_even = 1e30;
  auto parts = growth_parts("C14", law, balance_cases());
  parts.front().basis = above_fair_fill_level("B", largest_even);
  for (ClaimPart& part : parts) part = part_without_trees(std::move(part.statement), std::move(part.basis));
  return parts;
}

/// E B_n less log_(1/p) n, and what the first ratio of streams would make of it.
std::vector<NamedPlot> balance_residuals(const Evidence&) {
  std::vector<GrowthResidual> models;
  for (const char* text : {"patricia(1/2.74)", "patricia(0.23)"}) {
    const Model model = Model::parse(text);
    models.push_back({model, balance_constant(model).value().value, rival_patricia_orders(model).front()});
  }
  return {residual_picture({"C14_balance_residual", "Balance number of PATRICIA trees, less log_(1/p) n",
                            "mean B_n less the claim"},
                           statistic::balance, models)};
}

}  // namespace

Claim trie_balance_claim() {
  auto parts = balance_growth_parts();
  std::vector<ClaimPart> zones{
      zone_part(4, "nodes of b on a path - (2 + 2 eps log n/log(1/(1-p))) <= 0", "K96 Theorem B.1, proof",
                longest_b_excess),
      zone_part(5, "log |A| - log((1 + log n/log(1/(1-p))) n^(1-eps)) <= 0", "K96 Lemma B.1, proof",
                a_nodes_excess),
      zone_part(6, "log E(exceptions to A_0) - log of the bound on P(A_0^c) <= 0", "K96 Lemma B.1",
                exceptions_excess),
      zone_part(7, "log |B*| - log(n^(1+eps)/p) <= 0", "K96 Lemma B.2, proof", b_star_excess),
      zone_part(8, "log E(nodes of B* with more than M strings) - log of the bound <= 0, M = 1 + 1/eps",
                "K96 Lemma B.2", b_star_strings_excess)};
  std::ranges::move(zones, std::back_inserter(parts));
  return {"C14",
          "B_n <= (1+eps) log_(1/m) n: balance number of random tries and PATRICIA trees",
          "K96 Theorem B.1, Corollary B.1",
          std::move(parts),
          {},
          balance_residuals};
}

}  // namespace ramify
