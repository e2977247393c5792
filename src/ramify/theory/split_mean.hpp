#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// E X, X the limiting fraction of the nodes that go left: beta trees a/(a+b), bst 1/2, split x, dst and
/// patricia p (C8). aldous for beta > -1: 1/2. Nothing for catalan, chain and other aldous, whose
/// fraction tends to 0 or 1, nor for complete, whose fraction swings with n.
std::optional<Constant> split_mean(const Model& model);

}  // namespace ramify
