#pragma once

#include <functional>

#include "claim.hpp"

#include "ramify/model/model.hpp"
#include "ramify/statistic/order_count.hpp"

namespace ramify {

/// The basis of lim over k of lim over n of E X_k / E X_(k+1), X_k the nodes or streams of order k: of the
/// kind limit, extrapolated. Cost: 0.3 to 2 s.
std::function<Basis(const Evidence&)> order_ratio_limit(const Model& model, OrderCount::Of of);

}  // namespace ramify
