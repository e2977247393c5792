#pragma once

#include <optional>

#include "ramify/model/registry.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim S_n / log n, S_n the Horton-Strahler number, where a closed form is proved.
///
/// catalan: 1/log 4 (C22). split and patricia: 1/log(1/min(p,1-p)) (C10, C11, C17). Nothing for dst, for
/// which no source states it, nor for bst and beta, whose constant has no closed form.
std::optional<Constant> strahler_constant(const Model& model);

}  // namespace ramify
