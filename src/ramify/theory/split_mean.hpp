#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// E X, X the limiting fraction of the nodes that go left: a/(a+b) where it is beta(a,b), p where it
/// is constant (C8). Nothing where it tends to 0 or 1, or swings with n.
std::optional<Constant> split_mean(const Model& model);

}  // namespace ramify
