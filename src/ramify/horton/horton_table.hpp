#pragma once

#include <span>

#include "ramify/horton/horton_laws.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// One row for each ratio of each tree: data,quantity,estimator,first_order,last_order,value,standard_error,
/// error_from,bias,bias_from,model,trees,outlying,note (docs/horton-laws.md).
/// @param leaf_order  0 or 1: order of the external nodes
Table horton_table(std::span<const HortonLaws> trees, unsigned leaf_order);

}  // namespace ramify
