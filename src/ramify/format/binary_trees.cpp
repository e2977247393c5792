#include "ramify/format/binary_trees.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/tree/contract_unary.hpp"
#include "ramify/tree/resolve_forks.hpp"

namespace ramify {
namespace {

void require_no_wide_forks(const std::vector<RecordedTree>& trees, std::string_view file,
                           const ForkRule& rule) {
  const auto is_wide = [](const RecordedTree& tree) { return wide_forks(tree.tree) > 0; };
  const auto first = std::ranges::find_if(trees, is_wide);
  if (first == trees.end()) return;
  throw Error(
      fmt::format("{}: {} of {} trees have forks of three or more, first {} with {} of them", file,
                  std::ranges::count_if(trees, is_wide), trees.size(), first->name, wide_forks(first->tree)),
      rule.because, "resolve them with --resolve ladder or --resolve random, or leave these trees out");
}

}  // namespace

std::vector<RecordedTree> binary_trees(std::vector<RecordedTree> trees, std::string_view file,
                                       const ForkRule& rule) {
  for (std::size_t i = 0; i < trees.size(); ++i) {
    trees[i] = contract_unary(std::move(trees[i]));
    if (rule.resolution.empty()) continue;
    Stream stream({rule.seed, 0}, i);
    trees[i] = resolve_forks(std::move(trees[i]), parse_fork_resolution(rule.resolution), stream);
  }
  require_no_wide_forks(trees, file, rule);
  return trees;
}

}  // namespace ramify
