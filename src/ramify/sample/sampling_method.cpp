#include "ramify/sample/sampling_method.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace ramify {
namespace {

struct SinglePass {
  Measure measure;
  Pass pass;
  std::string_view name;
};
constexpr std::array<SinglePass, 6> single_passes{
    {{Measure::strahler, Pass::strahler, "strahler"},
     {Measure::height, Pass::height, "height"},
     {Measure::fill_level, Pass::fill_level, "fill_level"},
     {Measure::balance, Pass::balance, "balance"},
     {Measure::depth, Pass::depth, "depth"},
     {Measure::external_depth, Pass::external_depth, "external_depth"}}};

bool reads_any(const StatisticSet& statistics, std::initializer_list<Measure> measures) {
  return std::any_of(measures.begin(), measures.end(), [&](Measure m) { return statistics.reads(m); });
}

}  // namespace

SamplingMethod sampling_method(const StatisticSet& statistics, bool graft) {
  if (graft)
    for (const auto& single : single_passes)
      if (statistics.reads(single.measure) && statistics.reads_only(single.measure))
        return {single.pass, true};
  if (reads_any(statistics, {Measure::external_depth, Measure::shape, Measure::profile, Measure::bi_orders}))
    return {Pass::all, graft};
  if (reads_any(statistics, {Measure::depth, Measure::fill_level, Measure::balance}))
    return {Pass::full, graft};
  return {Pass::lean, graft};
}

std::string_view describe(Pass pass) {
  const auto* single = std::find_if(single_passes.begin(), single_passes.end(),
                                    [pass](const auto& entry) { return entry.pass == pass; });
  if (single != single_passes.end()) return single->name;
  if (pass == Pass::mean_counts) return "order, and mean counts,";
  return pass == Pass::lean ? "order, height and counts"
                            : "depth, fill level, balance, order, height and counts";
}

}  // namespace ramify
