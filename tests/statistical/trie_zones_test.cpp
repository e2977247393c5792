// The zones of Theorem B.1: against the definitions word by word, and random tries against tries of actual
// random strings.
#include "ramify/statistic/trie_zones.hpp"

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/error_of.hpp"
#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/random/uniform.hpp"

namespace ramify {
namespace {

std::vector<std::string> random_strings(std::size_t count, std::size_t bits, double p, Stream& stream) {
  std::set<std::string> strings;
  while (strings.size() < count) {
    std::string each;
    for (std::size_t i = 0; i < bits; ++i) each += uniform_open(stream) < p ? '0' : '1';
    strings.insert(each);
  }
  return {strings.begin(), strings.end()};
}

/// All words of 0 and 1 up to a length.
std::vector<std::string> words_up_to(std::size_t length) {
  std::vector<std::string> words{""};
  for (std::size_t i = 0; i < words.size() && words[i].size() < length; ++i) {
    words.push_back(words[i] + '0');
    words.push_back(words[i] + '1');
  }
  return words;
}

/// B19, C14 and B15 word by word; `levels` deep, which must hold the finite trie and zones a and b.
struct Literal {
  const TrieZoneRule& rule;
  const std::vector<std::string>& strings;

  std::size_t through(const std::string& word) const {
    std::size_t count = 0;
    for (const auto& each : strings) count += each.starts_with(word) ? 1 : 0;
    return count;
  }
  double probability(const std::string& word) const {
    double q = 1;
    for (const char bit : word) q *= bit == '0' ? rule.p : 1 - rule.p;
    return q;
  }
  static std::string sibling(std::string word) {
    word.back() = word.back() == '0' ? '1' : '0';
    return word;
  }
  char zone(const std::string& word) const {
    const double n = static_cast<double>(rule.n), mean = n * probability(word);
    if (mean >= std::pow(n, rule.epsilon)) return 'A';
    return mean > std::pow(n, -rule.epsilon) ? 'B' : 'C';
  }
  std::size_t balance(const std::string& word) const {
    std::size_t sum = 0;
    for (std::size_t level = 1; level <= word.size(); ++level) {
      const std::string prefix = word.substr(0, level);
      if (through(prefix) >= 1 && through(prefix) <= through(sibling(prefix))) ++sum;
    }
    return sum;
  }

  TrieZones measure(std::size_t levels) const {
    TrieZones zones;
    for (const std::string& word : words_up_to(levels)) {
      const char z = zone(word);
      const bool in_trie =
          through(word) >= 1 && (word.empty() || through(word.substr(0, word.size() - 1)) >= 2);
      if (in_trie) {
        ++(z == 'A' ? zones.nodes_a : z == 'B' ? zones.nodes_b : zones.nodes_c);
        zones.balance = std::max<std::uint64_t>(zones.balance, balance(word));
      }
      if (z == 'A' && !word.empty() &&
          (through(word) < through(sibling(word))) != (probability(word) < probability(sibling(word))))
        ++zones.exceptions;
      if (z == 'B' && (zone(word + '0') == 'C' || zone(word + '1') == 'C'))
        zones.largest_b_star = std::max<Size>(zones.largest_b_star, through(word));
      std::uint64_t b_nodes = 0;
      for (std::size_t level = 0; level <= word.size(); ++level)
        b_nodes += zone(word.substr(0, level)) == 'B' ? 1 : 0;
      zones.longest_b = std::max(zones.longest_b, b_nodes);
    }
    return zones;
  }
};

TEST(TrieZones, AreThoseOfTheDefinitions) {
  for (const double p : {0.3, 0.5, 0.62})
    for (std::uint64_t replicate = 0; replicate < 4; ++replicate) {
      Stream stream({test::seed_of("strings"), 0}, replicate);
      const auto strings = random_strings(12, 13, p, stream);
      const TrieZoneRule rule{12, p, 0.35};
      GivenTrieStrings given(strings);
      const TrieZones fast = measure_trie_zones(rule, given, {}), slow = Literal{rule, strings}.measure(13);
      EXPECT_EQ(fast.nodes_a, slow.nodes_a);
      EXPECT_EQ(fast.nodes_b, slow.nodes_b);
      EXPECT_EQ(fast.nodes_c, slow.nodes_c);
      EXPECT_EQ(fast.exceptions, slow.exceptions);
      EXPECT_EQ(fast.largest_b_star, slow.largest_b_star);
      EXPECT_EQ(fast.longest_b, slow.longest_b);
      EXPECT_EQ(fast.balance, slow.balance);
      EXPECT_LE(static_cast<double>(fast.longest_b), longest_b_bound(rule));
    }
}

// Kruszewski 1996, Figure B.2: leaves at 0100, 0101, 100, 101, 11, eleven nodes, B = 2.
TEST(TrieZones, OfTheThesisExample) {
  GivenTrieStrings strings({"01001", "01011", "10011", "10100", "11100"});
  std::map<std::string, Size> nodes;
  const TrieZones zones = measure_trie_zones({5, 0.5, 0.2}, strings,
                                             [&](const TrieNode& node) { nodes[node.path] = node.strings; });
  const std::map<std::string, Size> expected{{"", 5},     {"0", 2},    {"01", 2}, {"010", 2},
                                             {"0100", 1}, {"0101", 1}, {"1", 3},  {"10", 2},
                                             {"100", 1},  {"101", 1},  {"11", 1}};
  EXPECT_EQ(nodes, expected);
  EXPECT_EQ(zones.balance, 2u);
}

TEST(TrieZones, OfRandomCardinalitiesAreThoseOfRandomStrings) {
  constexpr Size n = 20;
  const auto of = [](double p, bool drawn, const char* tag) {
    test::Tally tally;
    for (std::uint64_t replicate = 0; replicate < test::replicates(4'000); ++replicate) {
      const StreamKey key{test::seed_of(tag), 0};
      Stream stream(key, replicate);
      RandomTrieStrings random(n, p, key, replicate);
      GivenTrieStrings given(drawn ? random_strings(n, 48, p, stream) : std::vector<std::string>{"0"});
      TrieStrings& strings = drawn ? static_cast<TrieStrings&>(given) : random;
      const TrieZones zones = measure_trie_zones({n, 0.3, 0.3}, strings, {});
      ++tally[{zones.largest_b_star, 100 * zones.exceptions + zones.balance}];
    }
    return tally;
  };
  const auto strings = of(0.3, true, "drawn strings");
  EXPECT_TRUE(test::agrees(test::two_samples("zones", of(0.3, false, "cardinalities"), strings)));
  EXPECT_TRUE(test::rejected(test::two_samples("zones, p off", of(0.35, false, "others"), strings)));
}

TEST(TrieStrings, AreRefused) {
  const auto refused = [](std::vector<std::string> strings) {
    return test::error_of([&] { GivenTrieStrings{std::move(strings)}; });
  };
  EXPECT_NE(refused({}).find("no string"), std::string::npos);
  EXPECT_NE(refused({"012"}).find("not made of 0 and 1"), std::string::npos);
  EXPECT_NE(refused({"0", ""}).find("string ''"), std::string::npos);
  EXPECT_NE(refused({"10", "0", "1"}).find("'10' begins with it"), std::string::npos);
  EXPECT_NE(refused({"1", "1"}).find("never part"), std::string::npos);
  EXPECT_EQ(refused({"1"}), "");
  EXPECT_THROW(RandomTrieStrings(5, 1.5, {1, 2}, 0), Error);
}

}  // namespace
}  // namespace ramify
