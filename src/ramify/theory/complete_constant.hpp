#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "ramify/model/model.hpp"
#include "ramify/theory/make_constant.hpp"

namespace ramify {

/// All subtrees of a node but one are perfect.
inline bool is_complete(const Model& model) {
  return std::holds_alternative<PerfectFraction>(model.character().fraction);
}

/// 1/log 2: of a complete tree, whose levels double, order, fill level and balance number are
/// floor(log2(n+1)), the height is one or two more, and the last node is no higher than one level above the
/// last.
inline std::optional<Constant> complete_constant(std::string_view name) {
  return make_constant(name, round_to_double(1 / log(Precise(2)), 1), "1/log 2", "A3; Knuth 1997, 2.3.4.5");
}

}  // namespace ramify
