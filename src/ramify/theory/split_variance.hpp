#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// Var X, X the limiting fraction of the nodes that go left: beta trees ab/((a+b)^2 (a+b+1)), bst 1/12; 0 for
/// split, dst and patricia, whose fraction is constant in the limit (C8). aldous(beta): that of
/// beta(beta+1,beta+1) for beta > -1. Nothing for catalan and others without a limiting fraction.
std::optional<Constant> split_variance(const Model& model);

}  // namespace ramify
