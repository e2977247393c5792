#include "ramify/draw/node_number.hpp"

#include <fmt/format.h>

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
  if (name == "order") return NodeNumber::order;
  if (name == "depth") return NodeNumber::depth;
  if (name == "leaves") return NodeNumber::leaves;
  if (name == "balance") return NodeNumber::balance;
  throw Error(
      fmt::format("--label {}", name), "no such number of a node",
      did_you_mean(name, {"order", "depth", "leaves", "balance"}) + "take order, depth, leaves or balance");
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
      break;
  }
  return balances(tree);
}

}  // namespace ramify
