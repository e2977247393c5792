#pragma once

#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify::test {

// P(left = i), i = 0..n-1, of every model, from the definition and in 50 digits (the beta by quadrature of
// its density): what pmf() and the samplers are held against. Also the laws that a plausible slip would draw
// from. n >= 1.

std::vector<double> uniform_law(Size n);
std::vector<double> split_law(Size n, double x);
std::vector<double> beta_law(Size n, double a, double b);
std::vector<double> beta_multinomial_law(Size n, double a, double b);
std::vector<double> catalan_law(Size n);
std::vector<double> dst_law(Size n, double p);
std::vector<double> patricia_law(Size n, double p);
std::vector<double> aldous_law(Size n, double beta);
std::vector<double> ford_law(Size n, double a);
std::vector<double> complete_law(Size n);
std::vector<double> chain_law(Size n);

/// Slip: Binomial(n, p) in place of Binomial(n-1, p), X = n left out (X16).
std::vector<double> thesis_binomial_law(Size n, double p);

/// Slip: left ~ Binomial(n, X) in place of Binomial(n-1, X), n left out.
std::vector<double> long_beta_multinomial_law(Size n, double a, double b);

/// Slip: left = 0..n-2 only.
std::vector<double> short_uniform_law(Size n);

/// Slip: left ~ floor((n-1)X), X ~ beta(a,b).
std::vector<double> short_beta_law(Size n, double a, double b);

/// Slip: n strings in place of n+1.
std::vector<double> short_patricia_law(Size n, double p);

/// Slip: C_i C_(n-2-i), i = 0..n-2.
std::vector<double> short_catalan_law(Size n);

/// Slip: n leaves in place of n+1.
std::vector<double> short_aldous_law(Size n, double beta);

/// Slip: n leaves in place of n+1.
std::vector<double> short_ford_law(Size n, double a);

/// Slip: the last level filled from the right.
std::vector<double> right_complete_law(Size n);

/// Slip: the split of n-1 nodes, the last one on the right.
std::vector<double> short_complete_law(Size n);

/// Slip: always on the left.
std::vector<double> left_chain_law(Size n);

}  // namespace ramify::test
