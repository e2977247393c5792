#pragma once

#include "ramify/core/cancellation.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// The expected numbers of streams of trees of n internal nodes, pooled over trees and orders:
///   (E M_0 + ... + E M_S - 1) / (E M_1 + ... + E M_S),
/// numerator and denominator the expectations of those of `streams_pooled_ratio` of one tree (the top order
/// has one stream). By law, no sampling: OrderMeans to some 2,000 nodes, LargeOrders beyond. 2 at n = 1.
///
/// @param model  a split model
/// @param n      >= 1
/// Throws Error where the model has no laws at that size, Interrupted. Cost: to 0.3 s.
double expected_pooled_ratio(const Model& model, Size n, const Cancellation& cancellation);

}  // namespace ramify
