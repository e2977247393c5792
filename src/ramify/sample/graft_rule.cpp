#include "ramify/sample/graft_rule.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/law/law_cost.hpp"
#include "ramify/sample/mean_counts_table.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

constexpr Size smallest_grafted = 1024;
constexpr LawCost table_cost{64e6, 1};

/// The recurrence of the statistic that a fold alone gives.
const Recurrence& recurrence_of(FoldSet pass) {
  const auto& all = statistics();
  const auto found = std::ranges::find(all, pass, [](const StatisticInfo& info) { return info.folds; });
  RAMIFY_EXPECTS(found != all.end());
  return found->get().law.recurrence;
}

Size largest_grafted_table(const Model& model, FoldSet pass) {
  if (is_walk(pass) || is_streamed(pass)) return 0;
  if (pass == orders_and_paths) return 12;
  if (pass == orders_and_height) return 28;
  if (pass == orders_and_mean_counts) return MeanCountsTable::largest(model);
  return std::bit_floor(largest_affordable(model, {recurrence_of(pass)}, table_cost));
}

/// The tables grow by a factor of 5 from step to step: more trees must pay for them.
Size orders_and_height_graft(Size n) {
  if (n < Size{1} << 16) return 16;
  return n < Size{1} << 22 ? 20 : 28;
}

/// Some 1000 subtrees are grafted, 400 at least, so that what their averages leave out is small
/// (mean_counts.hpp).
Size mean_counts_graft(Size n) {
  return std::bit_floor(n / 512);
}

Size single_graft(Size n) {
  return std::bit_floor(static_cast<Size>(8 * std::sqrt(static_cast<double>(n))));
}

Size graft(FoldSet pass, Size n) {
  if (pass == orders_and_height) return orders_and_height_graft(n);
  return pass == orders_and_mean_counts ? mean_counts_graft(n) : single_graft(n);
}

}  // namespace

GraftRule::GraftRule(const Model& model, SamplingMethod method)
    : model_(model),
      method_(method),
      largest_(method.graft && model.is_split() ? largest_grafted_table(model, method.pass) : 0),
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
  if (method_.pass == Folded::depth) return "the walk to the last node alone";
  if (method_.pass == Folded::external_depth) return "the walk to an external node alone";
  if (size(n) == 0) return "every node is grown";
  return fmt::format("{} of subtrees up to n = {} drawn from the exact law", ramify::describe(method_.pass),
                     size(n));
}

}  // namespace ramify
