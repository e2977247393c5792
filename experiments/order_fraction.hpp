#pragma once

#include "ramify/compare/finding.hpp"
#include "ramify/core/cancellation.hpp"
#include "ramify/model/model.hpp"
#include "ramify/statistic/order_count.hpp"

namespace ramify {

/// lim E N_1/n, order 1 of leaf order 0. Evidence of the kind limit, extrapolated: the value at n = 10^12,
/// and as its bound twice what it changed from 10^12/4, /16 and /64. Throws Interrupted.
Basis first_order_fraction(const Model& model, const Cancellation& cancellation);

/// lim E N_k/E N_(k+1) of a middle order k, in the same way.
Basis middle_order_ratio(const Model& model, OrderCount count, const Cancellation& cancellation);

}  // namespace ramify
