#pragma once

#include <vector>

#include "ramify/theory/precise.hpp"

namespace ramify {

/// nu_k = lim E M_k / n, k = 1..orders: streams of order k per internal node in large random binary search
/// trees.
///
/// nu_1 = 1/3, nu_2 = e^4/128 - e^2/8 + 233/384. The limit of nu_(k-1)/nu_k is the Horton ratio.
///
/// A random BST has the shape of a Yule tree. With D_k(t) = P(S > k) of the Yule tree at time t and M_k(t)
/// its mean number of streams of order k, D_(-1) = 1 and, for k >= 0, D_k(0) = M_(k+1)(0) = 0,
///   D_k' = D_k (1 - D_k) + (D_(k-1) - D_k)^2,   M_(k+1)' = M_(k+1) + (D_(k-1) - D_k)^2,   nu_k = lim e^(-t)
///   M_k(t).
/// @param orders  1..20
/// Relative error below 1e-20. Cost: 0.01 s an order. Kovchegov, Zaliapin 2017 (the same law for Kingman's
/// coalescent); docs/theory/horton-ratio.md.
std::vector<Precise> bst_stream_densities(int orders);

/// The limiting Horton ratio of random binary search trees, 3.0438..., extrapolated from the ratios of their
/// stream densities by Aitken's method, to the last digit of a double. Not 3, as Kruszewski 1996 believed
/// (C20).
Rounded bst_horton_ratio();

}  // namespace ramify
