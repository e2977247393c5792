#pragma once

#include <cstdint>
#include <vector>

#include "ramify/statistic/bi_orders.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/statistic/index_folds.hpp"

namespace ramify {

/// Everything one pass over one tree can say. A pass that does not fold a statistic leaves it 0 or empty
/// (sampling_method.hpp).
struct TreeMeasures {
  Size size = 0;
  std::uint32_t strahler = 0;
  std::uint32_t height = 0;
  HortonStrahler::Counts nodes{};
  HortonStrahler::Counts streams{};
  std::uint32_t depth = 0;
  std::uint32_t fill_level = 0;
  std::uint32_t balance = 0;
  std::uint32_t external_depth = 0;
  std::uint64_t path_length = 0;
  std::uint64_t sackin = 0;
  std::uint64_t colless = 0;  ///< of a tree that is not wide
  bool is_wide = false;       ///< a node has three children or more; known where colless is
  std::uint64_t width = 0;
  BiOrderCounts bi_orders;
  std::vector<double> toll_sums;  ///< of all_tolls()
  IndexFolds::Values indices{};
};

}  // namespace ramify
