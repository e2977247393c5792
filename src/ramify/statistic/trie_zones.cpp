#include "ramify/statistic/trie_zones.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/model/model_info.hpp"
#include "ramify/model/trie.hpp"
#include "ramify/random/variates.hpp"

namespace ramify {
namespace {

/// A node of the infinite trie that is still to be looked at.
struct OpenTrieNode {
  std::string path;
  Size first, strings;
  Size parent_strings, sibling_strings;
  double log_q, log_sibling_q;
  std::uint64_t b_above, balance;
};

double lesser(double p) {
  return std::min(p, 1 - p);
}

/// Walks in preorder, and keeps count.
class ZoneWalk {
 public:
  ZoneWalk(const TrieZoneRule& rule, TrieStrings& strings, const std::function<void(const TrieNode&)>& visit)
      : rule_(rule), strings_(strings), visit_(visit) {}

  TrieZones operator()(const Cancellation& cancellation) {
    constexpr std::uint64_t nodes_between_looks = 1 << 16;
    std::uint64_t nodes = 0;
    const Size n = strings_.count();
    open_.push_back({"", 0, n, n, 0, 0, 0, 0, 0});
    while (!open_.empty()) {
      if (nodes++ % nodes_between_looks == 0 && cancellation.requested()) throw Interrupted();
      const OpenTrieNode node = std::move(open_.back());
      open_.pop_back();
      look_at(node);
    }
    return zones_;
  }

 private:
  void look_at(const OpenTrieNode& node) {
    const TrieZone zone = rule_.zone(node.log_q);
    if (zone == TrieZone::a) check_order(node);
    if (node.strings >= 1 && (node.parent_strings >= 2 || node.path.empty())) count_node(node, zone);
    const std::uint64_t b_nodes = node.b_above + (zone == TrieZone::b ? 1 : 0);
    zones_.longest_b = std::max(zones_.longest_b, b_nodes);
    if (zone == TrieZone::c && node.strings < 2) return;
    open_children(node, zone, b_nodes);
  }

  void check_order(const OpenTrieNode& node) {
    if (node.path.empty()) return;
    const bool fewer = node.strings < node.sibling_strings;
    if (fewer != (node.log_q < node.log_sibling_q)) ++zones_.exceptions;
  }

  void count_node(const OpenTrieNode& node, TrieZone zone) {
    ++(zone == TrieZone::a ? zones_.nodes_a : zone == TrieZone::b ? zones_.nodes_b : zones_.nodes_c);
    zones_.balance = std::max(zones_.balance, node.balance);
    if (visit_) visit_({node.path, node.strings, node.log_q, zone});
  }

  void open_children(const OpenTrieNode& node, TrieZone zone, std::uint64_t b_nodes) {
    const Size left = node.strings == 0 ? 0 : strings_.left(node.first, node.strings, node.path.size());
    const Size right = node.strings - left;
    const double log_left = node.log_q + std::log(rule_.p), log_right = node.log_q + std::log1p(-rule_.p);
    const bool star =
        zone == TrieZone::b && (rule_.zone(log_left) == TrieZone::c || rule_.zone(log_right) == TrieZone::c);
    if (star) zones_.largest_b_star = std::max(zones_.largest_b_star, node.strings);
    const auto balance = [&](Size strings, Size sibling) {
      return node.balance + (strings >= 1 && strings <= sibling ? 1 : 0);
    };
    open_.push_back({node.path + '1', node.first + left, right, node.strings, left, log_right, log_left,
                     b_nodes, balance(right, left)});
    open_.push_back({node.path + '0', node.first, left, node.strings, right, log_left, log_right, b_nodes,
                     balance(left, right)});
  }

  const TrieZoneRule& rule_;
  TrieStrings& strings_;
  const std::function<void(const TrieNode&)>& visit_;
  std::vector<OpenTrieNode> open_;
  TrieZones zones_;
};

}  // namespace

RandomTrieStrings::RandomTrieStrings(Size n, double p, StreamKey key, std::uint64_t replicate)
    : n_(n), p_(p), stream_(key, replicate), beyond_(key, replicate, Lane::walk) {
  require_domain(Trie::info(), std::array{p});
}

Size RandomTrieStrings::left(Size, Size strings, Size) {
  return binomial_variate(strings < 2 ? beyond_ : stream_, strings, p_);
}

GivenTrieStrings::GivenTrieStrings(std::vector<std::string> strings) : strings_(std::move(strings)) {
  if (strings_.empty()) throw Error("no string", "a trie is made of one at least", "give some");
  for (const std::string& each : strings_)
    if (each.empty() || each.find_first_not_of("01") != std::string::npos)
      throw Error(fmt::format("string '{}'", each), "it is not made of 0 and 1", "write it like 01001");
  std::sort(strings_.begin(), strings_.end());
  for (std::size_t i = 1; i < strings_.size(); ++i)
    if (strings_[i].starts_with(strings_[i - 1]))
      throw Error(fmt::format("string '{}'", strings_[i - 1]),
                  fmt::format("'{}' begins with it, so they never part", strings_[i]),
                  "write more of their bits");
}

Size GivenTrieStrings::left(Size first, Size strings, Size level) {
  const auto begin = strings_.begin() + static_cast<std::ptrdiff_t>(first);
  return static_cast<Size>(
      std::count_if(begin, begin + static_cast<std::ptrdiff_t>(strings),
                    [level](const std::string& s) { return level >= s.size() || s[level] == '0'; }));
}

TrieZone TrieZoneRule::zone(double log_q) const {
  const double log_n = std::log(static_cast<double>(n)), mean = log_n + log_q;
  if (mean >= epsilon * log_n) return TrieZone::a;
  return mean > -epsilon * log_n ? TrieZone::b : TrieZone::c;
}

TrieZones measure_trie_zones(const TrieZoneRule& rule, TrieStrings& strings,
                             const std::function<void(const TrieNode&)>& visit,
                             const Cancellation& cancellation) {
  return ZoneWalk(rule, strings, visit)(cancellation);
}

double longest_b_bound(const TrieZoneRule& rule) {
  return 2 - 2 * rule.epsilon * std::log(static_cast<double>(rule.n)) / std::log1p(-lesser(rule.p));
}

double b_star_bound(const TrieZoneRule& rule) {
  return 1 + 1 / rule.epsilon;
}

double trie_balance_bound(const TrieZoneRule& rule) {
  const double m = lesser(rule.p);
  return 3 + 1 / rule.epsilon +
         (1 + 2 * rule.epsilon * std::log(m) / std::log1p(-m)) * std::log(static_cast<double>(rule.n)) /
             -std::log(m);
}

}  // namespace ramify
