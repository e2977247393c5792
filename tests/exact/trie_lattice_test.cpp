// What the ledger counts in tries, against the definitions word by word: zones of the infinite trie, siblings
// in the wrong order, fill levels.
#include "trie_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace ramify {
namespace {

double bernoulli_word(const std::string& word, double p) {
  double q = 1;
  for (const char bit : word) q *= bit == '0' ? p : 1 - p;
  return q;
}

/// 'a', 'b' or 'c', by n q.
char zone_by_words(const std::string& word, const TrieZoneRule& rule) {
  const double n = static_cast<double>(rule.n), mean = n * bernoulli_word(word, rule.p);
  if (mean >= std::pow(n, rule.epsilon)) return 'a';
  return mean > std::pow(n, -rule.epsilon) ? 'b' : 'c';
}

double ways_to_choose(Size n, Size k) {
  double ways = 1;
  for (Size i = 0; i < k; ++i) ways *= static_cast<double>(n - i) / static_cast<double>(i + 1);
  return ways;
}

/// P(Bin(n, q) >= m), term by term.
double binomial_from(Size n, double q, Size m) {
  double sum = 0;
  for (Size k = m; k <= n; ++k)
    sum += ways_to_choose(n, k) * std::pow(q, static_cast<double>(k)) *
           std::pow(1 - q, static_cast<double>(n - k));
  return sum;
}

/// Of two children of probabilities q and r: P(the strings through them are in that relation).
template <class Relation>
double of_siblings(Size n, double q, double r, Relation relation) {
  double sum = 0;
  for (Size k = 0; k <= n; ++k)
    for (Size l = 0; k + l <= n; ++l)
      if (relation(k, l))
        sum += ways_to_choose(n, k) * ways_to_choose(n - k, l) * std::pow(q, static_cast<double>(k)) *
               std::pow(r, static_cast<double>(l)) *
               std::pow(std::max(0.0, 1 - q - r), static_cast<double>(n - k - l));
  return sum;
}

struct ByWords {
  TrieZoneCounts counts;
  double exceptions = 0;
};

/// Looks at every word from here down through zones a and b.
void walk_words(const std::string& word, std::uint64_t b_above, const TrieZoneRule& rule, ByWords& all) {
  const char zone = zone_by_words(word, rule);
  if (zone == 'c') return;
  const std::string unlikely = word + '0', likely = word + '1';
  const std::uint64_t b_nodes = b_above + (zone == 'b' ? 1 : 0);
  all.counts.longest_b = std::max(all.counts.longest_b, b_nodes);
  all.counts.a_nodes += zone == 'a' ? 1 : 0;
  if (zone == 'b' && zone_by_words(unlikely, rule) == 'c') {
    all.counts.b_star_nodes += 1;
    const auto above = static_cast<Size>(std::floor(b_star_bound(rule))) + 1;
    all.counts.b_star_above += binomial_from(rule.n, bernoulli_word(word, rule.p), above);
  }
  const double q = bernoulli_word(unlikely, rule.p), r = bernoulli_word(likely, rule.p);
  if (zone_by_words(unlikely, rule) == 'a')
    all.exceptions += of_siblings(rule.n, q, r, [](Size k, Size l) { return k >= l; });
  if (zone_by_words(likely, rule) == 'a')
    all.exceptions += of_siblings(rule.n, q, r, [](Size k, Size l) { return k > l; });
  walk_words(unlikely, b_nodes, rule, all);
  walk_words(likely, b_nodes, rule, all);
}

TEST(TrieZoneCounts, AreThoseOfEveryWord) {
  for (const double p : {0.23, 0.41})
    for (const Size n : {Size{3}, Size{7}, Size{24}}) {
      const TrieZoneRule rule{n, p, 0.3};
      ByWords expected;
      walk_words("", 0, rule, expected);
      const TrieZoneCounts counts = trie_zone_counts(rule);
      EXPECT_EQ(counts.longest_b, expected.counts.longest_b);
      EXPECT_NEAR(counts.a_nodes, expected.counts.a_nodes, 1e-9);
      EXPECT_NEAR(counts.b_star_nodes, expected.counts.b_star_nodes, 1e-9);
      EXPECT_NEAR(counts.b_star_above, expected.counts.b_star_above, 1e-12);
      EXPECT_NEAR(expected_exceptions(rule, WrongOrder(p, n)), expected.exceptions, 1e-12);
      EXPECT_GT(expected.exceptions, 0);
    }
}

TEST(TrieZoneCounts, HaveThePathOfTheWalkThroughATrie) {
  RandomTrieStrings strings(200, 0.3, {1, 2}, 0);
  const TrieZoneRule rule{200, 0.3, 0.35};
  EXPECT_EQ(trie_zone_counts(rule).longest_b, measure_trie_zones(rule, strings, {}).longest_b);
}

/// P(a node of that level is without strings), by inclusion and exclusion over the sets of empty ones.
double some_node_empty(Size n, double p, std::size_t level) {
  std::vector<std::string> words{""};
  for (std::size_t i = 0; words[i].size() < level; ++i)
    for (const char bit : {'0', '1'}) words.push_back(words[i] + bit);
  const std::size_t nodes = std::size_t{1} << level, first = words.size() - nodes;
  double none = 0;
  for (std::size_t set = 0; set < std::size_t{1} << nodes; ++set) {
    double left = 1;
    int sign = 1;
    for (std::size_t i = 0; i < nodes; ++i)
      if ((set >> i) % 2 == 1) {
        left -= bernoulli_word(words[first + i], p);
        sign = -sign;
      }
    none += sign * std::pow(std::max(left, 0.0), static_cast<double>(n));
  }
  return 1 - none;
}

TEST(TrieFillLevel, IsBelowALevelWithAnEmptyNode) {
  for (const double p : {0.23, 0.5}) {
    std::vector<double> not_full(31);
    not_full[0] = 1;
    for (std::size_t level = 1; level <= 3; ++level) {
      not_full = not_full_to_next(not_full, p);
      for (const Size n : {Size{1}, Size{5}, Size{12}, Size{30}})
        EXPECT_NEAR(not_full[n], some_node_empty(n, p, level), 1e-12) << n << ' ' << level;
    }
  }
}

}  // namespace
}  // namespace ramify
