#pragma once

#include <optional>

#include "ramify/model/model.hpp"
#include "ramify/theory/constant.hpp"

namespace ramify {

/// lim S_n / log n, S_n the Horton-Strahler number: 1/log R, R the Horton ratio of streams.
///
/// From horton_ratio_constant, and nothing where it has nothing: of the uniform tree 1/log 4 (C22), of a
/// constant X 1/log(1/min(p,1-p)) (C10, C11, C17), of a uniform X 0.898379055055633 and not the 1/log 3 of
/// Kruszewski 1996 (C20).
std::optional<Constant> strahler_constant(const Model& model);

/// The same for a caller that has computed the Horton ratio of the model already.
std::optional<Constant> strahler_constant(const Model& model, const std::optional<Constant>& horton_ratio);

}  // namespace ramify
