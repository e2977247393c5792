#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// Var X, X the limiting fraction of the nodes that go left: ab/((a+b)^2 (a+b+1)) where it is beta(a,b); 0
/// where it is constant in the limit (C8). Nothing where there is none.
std::optional<Constant> split_variance(const Model& model);

}  // namespace ramify
