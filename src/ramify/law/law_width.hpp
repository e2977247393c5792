#pragma once

#include "ramify/model/model.hpp"

namespace ramify {

/// About how many depths DepthLaw stores for one size n: those at which P(D_n = d) is not below 1e-20.
///
/// From Chernoff's bounds of the sum of the logarithms of d size-biased split fractions X: with M(t) = E[X^t
/// + (1-X)^t], d reaches from max over u of (u log n - 46)/log M(1-u) to min over s of (s log n + 46)/(-log
/// M(1+s)), and no further than n. Where X is constant, log(1 + 2n min(X,1-X)) stands for log n: below, a
/// step takes off one node only. Where there is no X and depths grow like n^e: (1/2 + 0.9 e) 46^(1-e) (n^e -
/// 1)/e, a fit, and at most its limit at e = 0 where no side is without a leaf; at e = 1/2 13.6 sqrt(n), as
/// of the uniform tree P(D_n > d) ~ exp(-d^2/(4n)); at e = 1 one. Where X is unknown, it is taken for the
/// beta law with the mean and variance of the row of n; a guess. Else right to a factor of 2. O(1); O(n)
/// where X is unknown.
double depth_width(const Model& model, Size n);

/// About how many heights HeightLaw stores for one size n: from 0.8 of the typical height, below which P(H_n
/// <= h) soon vanishes, to where the bound n^t M(t)^h of P(H_n > h) falls to 1e-35 for the best t. Where
/// there is no X, or it is unknown, as above with 81 for 46; where a size splits in one way: 1. Right to a
/// factor of 2. O(1).
double height_width(const Model& model, Size n);

}  // namespace ramify
