#pragma once

namespace ramify {

/// Horton's first law with ratio R and orders 1..S, leaf order 0: R^(S-i) nodes of order i, so
/// (R^S - 1)/(R - 1) internal nodes; S where R = 1. NaN unless R > 0 (B12; Kruszewski 1996, 3.1.3).
double horton_size(double ratio, double order);

/// Its inverse, the order at which the law has n internal nodes: log(n (R-1) + 1)/log R; n where R = 1. NaN
/// unless R > 0 and n (R-1) > -1 (B12).
double horton_order(double ratio, double n);

}  // namespace ramify
