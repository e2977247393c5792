#include "ramify/sample/graft_rule.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "ramify/law/law_cost.hpp"
#include "ramify/sample/mean_counts.hpp"

namespace ramify {
namespace {

constexpr Size smallest_grafted = 1024;
constexpr LawCost table_cost{64e6, 1};

Size largest_table(const Model& model, Pass pass) {
  switch (pass) {
    case Pass::depth:
    case Pass::external_depth:
    case Pass::all:
      return 0;
    case Pass::full:
      return 12;
    case Pass::lean:
      return 28;
    case Pass::mean_counts:
      return MeanCounts::largest_grafted;
    case Pass::height:
      return std::bit_floor(largest_affordable(model, LawKind::height, table_cost));
    case Pass::strahler:
    case Pass::fill_level:
    case Pass::balance:
      break;
  }
  return std::bit_floor(largest_affordable(model, LawKind::bounded, table_cost));
}

/// The tables grow by a factor of 5 from step to step: more trees must pay for them.
Size lean_graft(Size n) {
  if (n < Size{1} << 16) return 16;
  return n < Size{1} << 22 ? 20 : 28;
}

/// At least some 400 subtrees are grafted, so that what their averages leave out is small (mean_counts.hpp).
Size mean_counts_graft(Size n) {
  return std::min<Size>(n < Size{1} << 26 ? 2048 : MeanCounts::largest_grafted, std::bit_floor(n / 256));
}

Size single_graft(Size n) {
  return std::bit_floor(static_cast<Size>(8 * std::sqrt(static_cast<double>(n))));
}

bool is_walk(Pass pass) {
  return pass == Pass::depth || pass == Pass::external_depth;
}

Size graft(Pass pass, Size n) {
  switch (pass) {
    case Pass::lean:
      return lean_graft(n);
    case Pass::mean_counts:
      return mean_counts_graft(n);
    default:
      return single_graft(n);
  }
}

}  // namespace

GraftRule::GraftRule(const Model& model, SamplingMethod method)
    : model_(model),
      method_(method),
      largest_(method.graft && model.is_split() ? largest_table(model, method.pass) : 0),
      depth_exponent_(model.is_split() ? depth_exponent(model.character().fraction) : 0) {}

Size GraftRule::size(Size n) const {
  if (n < smallest_grafted) return 0;
  return std::min(largest_, graft(method_.pass, n));
}

double GraftRule::grown_nodes(Size n) const {
  if (!model_.is_split()) return model_.grown().expected_nodes(n);
  const double nodes = static_cast<double>(n);
  if (is_walk(method_.pass)) return std::max(std::pow(nodes, depth_exponent_), std::log2(nodes + 2));
  const double grafted = static_cast<double>(size(n));
  if (grafted == 0) return nodes;
  return nodes / std::pow(grafted / 2, 1 - depth_exponent_);
}

std::string GraftRule::describe(Size n) const {
  if (!model_.is_split()) return "every node is grown";
  if (method_.pass == Pass::depth) return "the walk to the last node alone";
  if (method_.pass == Pass::external_depth) return "the walk to an external node alone";
  if (size(n) == 0) return "every node is grown";
  return fmt::format("{} of subtrees up to n = {} drawn from the exact law", ramify::describe(method_.pass),
                     size(n));
}

}  // namespace ramify
