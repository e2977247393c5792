#include "ramify/draw/node_number.hpp"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/error.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/statistic/balance.hpp"
#include "ramify/statistic/node_labels.hpp"
#include "ramify/tree/measure.hpp"

namespace ramify {
namespace {

template <class Values>
std::vector<std::uint64_t> as_numbers(const Values& values, unsigned more = 0) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(values.size());
  for (const auto value : values) numbers.push_back(std::uint64_t{value} + more);
  return numbers;
}

std::vector<std::uint64_t> balances(const Tree& tree) {
  std::vector<std::uint64_t> numbers(tree.node_count());
  BalanceByLeaves fold;
  measure(tree, fold,
          [&](std::size_t node, const BalanceByLeaves::Value& value) { numbers[node] = value.balance; });
  return numbers;
}

}  // namespace

NodeNumber parse_node_number(const std::string& name) {
  using enum NodeNumber;
  constexpr std::array<std::pair<std::string_view, NodeNumber>, 5> numbers{
      {{"order", order},
       {"depth", depth},
       {"leaves", leaves},
       {"balance", balance},
       {"alternate_balance", alternate_balance}}};
  std::vector<std::string> known;
  for (const auto& [own, number] : numbers) {
    if (name == own) return number;
    known.emplace_back(own);
  }
  throw Error(fmt::format("--label {}", name), "no such number of a node",
              did_you_mean(name, known) + fmt::format("take one of {}", fmt::join(known, ", ")));
}

std::vector<std::uint64_t> node_numbers(const Tree& tree, NodeNumber kind, unsigned leaf_order) {
  switch (kind) {
    case NodeNumber::order:
      return as_numbers(strahler_orders(tree), leaf_order);
    case NodeNumber::depth:
      return as_numbers(depths(tree));
    case NodeNumber::leaves:
      return as_numbers(magnitudes(tree));
    case NodeNumber::balance:
      return balances(tree);
    case NodeNumber::alternate_balance:
      break;
  }
  return as_numbers(balances(tree), 1);
}

}  // namespace ramify
