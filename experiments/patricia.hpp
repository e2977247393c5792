#pragma once

#include <vector>

#include "growth.hpp"

namespace ramify {

/// Random PATRICIA trees at the probabilities of the thesis' species and at 1/2, each with its ladder of the
/// statistic; p = 1/2 to `largest_even`, for there values follow so sharply from n that no grid resolves them
/// far up.
std::vector<GrowthCase> patricia_cases(const StatisticInfo& statistic, double largest_even);

/// lim X_n / log n at p = 1/2 of an X between the fill level F_n and log2(n+1) in every tree: between the
/// limit of F_n and 1/log 2.
/// @param letter  "S"
std::function<Basis(const Evidence&)> above_fair_fill_level(std::string_view letter, double largest_even);

/// 1/log of the ratio of streams of order 0 and 1, h/(pq), and of the depth.
std::vector<NamedValue> rival_patricia_orders(const Model& model);

}  // namespace ramify
