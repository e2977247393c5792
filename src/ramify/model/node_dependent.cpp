#include "ramify/model/node_dependent.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

/// 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, ... and last, last >= 1.
std::vector<Size> trial_steps(Size last) {
  std::vector<Size> steps;
  for (Size step = 1; step < last; step += std::max<Size>(1, step / 4)) steps.push_back(step);
  steps.push_back(last);
  return steps;
}

}  // namespace

void refuse_node_value(const Formula& formula, std::string_view model, std::string_view parameter,
                       const NodePlace& node, double value, std::string_view domain) {
  throw Error(fmt::format("{}: {} = '{}' is {} at d = {}, size = {}, n = {}", model, parameter,
                          formula.text(), value, node.depth, node.size, node.n),
              domain, "change the formula, or bound it with min, max or a ? b : c");
}

std::vector<NodePlace> trial_places(Size n) {
  std::vector<NodePlace> places;
  if (n < 2) return places;
  // A node of depth d has d-1 nodes above it.
  for (const Size depth : trial_steps(n - 1))
    for (const Size size : trial_steps(n - depth + 1))
      if (size >= 2 && (depth > 1 || size == n)) places.push_back({size, depth, n});
  return places;
}

}  // namespace ramify
