#pragma once

#include <cstdint>

#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {

/// Everything one pass over one tree can say; the full pass fills all of it, the lean one leaves the last
/// three 0.
struct TreeMeasures {
  Size size = 0;
  std::uint32_t strahler = 0;
  std::uint32_t height = 0;
  HortonStrahler::Counts nodes{};
  HortonStrahler::Counts streams{};
  std::uint32_t depth = 0;
  std::uint32_t fill_level = 0;
  std::uint32_t balance = 0;
};

}  // namespace ramify
