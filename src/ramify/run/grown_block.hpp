#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ramify/run/cell_accumulator.hpp"
#include "ramify/sample/grow_blocks.hpp"

namespace ramify {

/// A block of a cell when it is grown: all that a store, or another machine, has to hand over.
struct GrownBlock {
  Block block;  ///< its job is the cell's place in the plan
  CellSums sums;
};

/// Of a cell of the plan, before its first tree.
CellAccumulator no_trees(const Plan& plan, std::size_t cell);

/// Grows the trees of a block of the plan's cells. Throws Interrupted.
GrownBlock grown_block(const Plan& plan, const Block& block, const BlockTrees& trees);

/// As CBOR (RFC 8949), every bit of it.
std::vector<std::uint8_t> encode(const GrownBlock& grown);

/// Nothing where the bytes are damaged, or of no block of this plan.
std::optional<GrownBlock> decode_block(std::span<const std::uint8_t> bytes, const Plan& plan);

}  // namespace ramify
