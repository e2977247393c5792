#pragma once

#include <functional>
#include <vector>

#include "ramify/random/stream.hpp"
#include "ramify/shape/node_facts.hpp"
#include "ramify/shape/rule_info.hpp"

namespace ramify {

/// What a rule for a radius or a length is given.
struct ExtentQuestion {
  const NodeFacts& node;
  const NodeFacts& root;
  double of_mother;  ///< the same extent of the mother as it was placed; of the root, nothing to rely on
  Stream& chance;
};

/// Radius or length of a node's cylinder, in the unit of its constants.
using ExtentRule = std::function<double(const ExtentQuestion&)>;

/// All rules for radii and lengths, in the order they are listed.
const std::vector<RuleInfo<ExtentRule>>& extent_rules();

}  // namespace ramify
