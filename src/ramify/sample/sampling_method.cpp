#include "ramify/sample/sampling_method.hpp"

#include <algorithm>
#include <array>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

struct NamedPass {
  FoldSet pass;
  std::string_view name;
};

constexpr std::array<NamedPass, 6> alone{{{Folded::strahler, "strahler"},
                                          {Folded::height, "height"},
                                          {Folded::fill_level, "fill_level"},
                                          {Folded::balance, "balance"},
                                          {Folded::depth, "depth"},
                                          {Folded::external_depth, "external_depth"}}};

/// The least first.
constexpr std::array<NamedPass, 4> together{
    {{orders_and_height, "order, height and counts"},
     {orders_and_paths, "depth, fill level, balance, order, height and counts"},
     {all_but_indices, "all but indices"},
     {all_folds, "everything"}}};

}  // namespace

SamplingMethod sampling_method(const StatisticSet& statistics, bool graft) {
  const FoldSet folds = statistics.folds();
  if (graft && std::ranges::find(alone, folds, &NamedPass::pass) != alone.end()) return {folds, true};
  const auto least =
      std::ranges::find_if(together, [&](const auto& set) { return set.pass.contains(folds); });
  RAMIFY_EXPECTS(least != together.end());
  return {least->pass, graft};
}

std::string_view describe(FoldSet pass) {
  for (const NamedPass& single : alone)
    if (single.pass == pass) return single.name;
  for (const NamedPass& several : together)
    if (several.pass == pass) return several.name;
  return "order, and mean counts,";
}

}  // namespace ramify
