#include "ramify/sample/sampling_method.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace ramify {
namespace {

constexpr Size smallest_grafted = 1024;

/// The largest tables of a single statistic, by the seconds they take to build (bench/README.md).
struct TableLimits {
  Size bounded;  ///< order, fill level, balance
  Size height;
};

TableLimits limits(const Bst&) {
  return {16384, 4096};
}
TableLimits limits(const Beta&) {
  return {8192, 4096};
}
TableLimits limits(const Catalan&) {
  return {8192, 1024};
}
TableLimits limits(const Dst&) {
  return {32768, 8192};
}
TableLimits limits(const Patricia&) {
  return {32768, 8192};
}
TableLimits limits(const FixedSplit&) {
  return {65536, 65536};
}

Size lean_graft(Size n) {
  if (n < Size{1} << 16) return 16;
  if (n < Size{1} << 22) return 20;
  return n < Size{1} << 28 ? 26 : 28;
}

struct SinglePass {
  Measure measure;
  Pass pass;
  std::string_view name;
};
constexpr std::array<SinglePass, 5> single_passes{{{Measure::strahler, Pass::strahler, "strahler"},
                                                   {Measure::height, Pass::height, "height"},
                                                   {Measure::fill_level, Pass::fill_level, "fill_level"},
                                                   {Measure::balance, Pass::balance, "balance"},
                                                   {Measure::depth, Pass::depth, "depth"}}};

std::string_view drawn(Pass pass) {
  const auto* single = std::find_if(single_passes.begin(), single_passes.end(),
                                    [pass](const auto& entry) { return entry.pass == pass; });
  if (single != single_passes.end()) return single->name;
  return pass == Pass::lean ? "order, height and counts" : "all statistics";
}

}  // namespace

SamplingMethod sampling_method(const StatisticSet& statistics, bool graft) {
  if (graft)
    for (const auto& single : single_passes)
      if (statistics.reads(single.measure) && statistics.reads_only(single.measure))
        return {single.pass, true};
  for (const Measure outside_lean : {Measure::depth, Measure::fill_level, Measure::balance})
    if (statistics.reads(outside_lean)) return {Pass::full, graft};
  return {Pass::lean, graft};
}

Size graft_size(const Model& model, SamplingMethod method, Size n) {
  if (!method.graft || n < smallest_grafted || method.pass == Pass::depth) return 0;
  if (method.pass == Pass::lean) return lean_graft(n);
  if (method.pass == Pass::full) return 12;
  const auto tables = std::visit([](const auto& law) { return limits(law); }, model.law());
  const Size limit = method.pass == Pass::height ? tables.height : tables.bounded;
  return std::min(limit, std::bit_floor(static_cast<Size>(8 * std::sqrt(static_cast<double>(n)))));
}

double grown_nodes(const Model& model, SamplingMethod method, Size n) {
  const double nodes = static_cast<double>(n);
  if (method.pass == Pass::depth)
    return std::holds_alternative<Catalan>(model.law()) ? std::sqrt(nodes) : std::log2(nodes + 2);
  const double grafted = static_cast<double>(graft_size(model, method, n));
  if (grafted == 0) return nodes;
  if (std::holds_alternative<Catalan>(model.law())) return nodes / std::sqrt(std::numbers::pi * grafted);
  return 2 * nodes / grafted;
}

std::string describe(const Model& model, SamplingMethod method, Size n) {
  if (method.pass == Pass::depth) return "the walk to the last node alone";
  const Size grafted = graft_size(model, method, n);
  if (grafted == 0) return "every node is grown";
  return fmt::format("{} of subtrees up to n = {} drawn from the exact law", drawn(method.pass), grafted);
}

}  // namespace ramify
