#include "ramify/run/grown_block.hpp"

#include <nlohmann/json.hpp>

#include "ramify/accumulate/accumulator_json.hpp"

namespace ramify {
namespace {

using nlohmann::json;

bool fits(const GrownBlock& grown, const Plan& plan) {
  const auto& [block, sums] = grown;
  if (block.job >= plan.cells.size()) return false;
  if (block.first >= block.last || block.last > plan.cells[block.job].replicates) return false;
  const CellAccumulator empty = no_trees(plan, block.job);
  return sums.wholes.size() == empty.sums().wholes.size() && sums.reals.size() == empty.sums().reals.size();
}

}  // namespace

CellAccumulator no_trees(const Plan& plan, std::size_t cell) {
  return {plan.statistics, plan.cells[cell].model.largest_order(plan.cells[cell].n)};
}

GrownBlock grown_block(const Plan& plan, const Block& block, const BlockTrees& trees) {
  CellAccumulator sums = no_trees(plan, block.job);
  trees.each([&](std::uint64_t, const TreeMeasures& measures) { sums.add(measures); });
  return {block, sums.sums()};
}

std::vector<std::uint8_t> encode(const GrownBlock& grown) {
  const auto& [block, sums] = grown;
  return json::to_cbor({{"cell", block.job},
                        {"first", block.first},
                        {"last", block.last},
                        {"index", block.index},
                        {"wholes", sums.wholes},
                        {"reals", sums.reals},
                        {"nodes", sums.nodes},
                        {"streams", sums.streams}});
}

std::optional<GrownBlock> decode_block(std::span<const std::uint8_t> bytes, const Plan& plan) {
  try {
    const json j = json::from_cbor(bytes.begin(), bytes.end());
    GrownBlock grown{
        {j.at("cell"), j.at("first"), j.at("last"), j.at("index")},
        {j.at("wholes").get<std::vector<WholeSummary>>(), j.at("reals").get<std::vector<RealSummary>>(),
         j.at("nodes").get<OrderTotals>(), j.at("streams").get<OrderTotals>()}};
    return fits(grown, plan) ? std::optional(std::move(grown)) : std::nullopt;
  } catch (const json::exception&) {
    return std::nullopt;  // damaged
  } catch (const Error&) {
    return std::nullopt;  // not the sums of any trees
  }
}

}  // namespace ramify
