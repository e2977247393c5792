#include "trie_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/core/contract.hpp"
#include "ramify/model/binomial_weights.hpp"

namespace ramify {
namespace {

/// The nodes with so many 0s and 1s on their paths.
struct NodeKind {
  unsigned zeros, ones;
  double log_q;
  double nodes;
  TrieZone zone;
};

double log_q_of(const TrieZoneRule& rule, unsigned zeros, unsigned ones) {
  return zeros * std::log(rule.p) + ones * std::log1p(-rule.p);
}

TrieZone zone_of(const TrieZoneRule& rule, unsigned zeros, unsigned ones) {
  return rule.zone(log_q_of(rule, zeros, ones));
}

/// Calls visit with every kind of zones a and b, parents before children.
template <class Visit>
void each_kind(const TrieZoneRule& rule, Visit visit) {
  for (unsigned zeros = 0; zone_of(rule, zeros, 0) != TrieZone::c; ++zeros)
    for (unsigned ones = 0; zone_of(rule, zeros, ones) != TrieZone::c; ++ones) {
      const double log_nodes =
          std::lgamma(zeros + ones + 1.0) - std::lgamma(zeros + 1.0) - std::lgamma(ones + 1.0);
      visit(NodeKind{zeros, ones, log_q_of(rule, zeros, ones), std::exp(log_nodes),
                     zone_of(rule, zeros, ones)});
    }
}

/// P(Bin(n, q) >= m), q small, from its terms upward.
double tail_from(double n, double log_q, Size m) {
  const double q = std::exp(log_q);
  double log_term = static_cast<double>(m) * log_q + (n - static_cast<double>(m)) * std::log1p(-q);
  for (Size i = 0; i < m; ++i)
    log_term += std::log(n - static_cast<double>(i)) - std::log(static_cast<double>(i) + 1);
  constexpr double negligible = 1e-17;
  double term = std::exp(log_term), sum = 0;
  for (auto k = static_cast<double>(m); k <= n; ++k) {
    sum += term;
    const double ratio = (n - k) / (k + 1) * q / (1 - q);
    if (ratio < 1 && term < negligible * sum) break;
    term *= ratio;
  }
  return sum;
}

/// E f(C), C ~ Bin(n, q) strings through a node.
double mean_over_strings(Size n, double log_q, const std::vector<double>& f) {
  if (log_q == 0) return f[n];
  constexpr double cutoff = 1e-40;
  const WeightWindow window = binomial_window(n, std::exp(log_q), cutoff);
  double mean = 0;
  for (std::size_t i = 0; i < window.weights.size(); ++i) mean += window.weights[i] * f[window.first + i];
  return mean;
}

}  // namespace

TrieZoneCounts trie_zone_counts(const TrieZoneRule& rule) {
  RAMIFY_EXPECTS(rule.p < 0.5);
  const auto n = static_cast<double>(rule.n);
  const auto above = static_cast<Size>(std::floor(b_star_bound(rule))) + 1;
  TrieZoneCounts counts;
  std::vector<std::uint64_t> most_b;  // on a path to the kind with so many 1s, of the last number of 0s
  each_kind(rule, [&](const NodeKind& kind) {
    if (most_b.size() <= kind.ones) most_b.resize(kind.ones + 1);
    std::uint64_t& b_nodes = most_b[kind.ones];
    if (kind.ones > 0) b_nodes = std::max(b_nodes, most_b[kind.ones - 1]);
    if (kind.zone == TrieZone::a) {
      counts.a_nodes += kind.nodes;
      return;
    }
    counts.longest_b = std::max(counts.longest_b, ++b_nodes);
    if (zone_of(rule, kind.zeros + 1, kind.ones) != TrieZone::c) return;
    counts.b_star_nodes += kind.nodes;
    if (above <= rule.n) counts.b_star_above += kind.nodes * tail_from(n, kind.log_q, above);
  });
  return counts;
}

WrongOrder::WrongOrder(double p, Size largest) : at_least{1}, more{0} {
  constexpr double cutoff = 1e-60;
  for (Size c = 1; c <= largest; ++c) {
    const WeightWindow window = binomial_window(c, p, cutoff);
    double from_half = 0, above_half = 0;
    for (std::size_t i = window.weights.size(); i-- > 0;) {
      const Size strings = window.first + i;
      if (2 * strings > c) above_half += window.weights[i];
      if (2 * strings >= c) from_half += window.weights[i];
    }
    at_least.push_back(from_half);
    more.push_back(above_half);
  }
}

double expected_exceptions(const TrieZoneRule& rule, const WrongOrder& wrong) {
  RAMIFY_EXPECTS(rule.p < 0.5 && wrong.more.size() > rule.n);
  double exceptions = 0;
  each_kind(rule, [&](const NodeKind& parent) {
    if (parent.zone != TrieZone::a) return;
    const bool likely = zone_of(rule, parent.zeros, parent.ones + 1) == TrieZone::a;
    const bool unlikely = zone_of(rule, parent.zeros + 1, parent.ones) == TrieZone::a;
    // C < C' of the likely child; not of the unlikely one
    if (likely) exceptions += parent.nodes * mean_over_strings(rule.n, parent.log_q, wrong.more);
    if (unlikely) exceptions += parent.nodes * mean_over_strings(rule.n, parent.log_q, wrong.at_least);
  });
  return exceptions;
}

std::vector<double> not_full_to_next(const std::vector<double>& not_full, double p) {
  constexpr double cutoff = 1e-60;
  std::vector<double> next(not_full.size());
  next[0] = 1;
  for (Size n = 1; n < next.size(); ++n) {
    const WeightWindow window = binomial_window(n, p, cutoff);
    for (std::size_t i = 0; i < window.weights.size(); ++i) {
      const double left = not_full[window.first + i], right = not_full[n - window.first - i];
      next[n] += window.weights[i] * (left + right * (1 - left));
    }
  }
  return next;
}

}  // namespace ramify
