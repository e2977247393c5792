#pragma once

#include <concepts>
#include <cstdint>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// Sizes up to 2^50: above, a double no longer reaches every index 0..n-1.
inline constexpr Size max_double_size = Size{1} << 50;

/// How the n-1 other internal nodes of a split tree of size n divide between left and right.
///
/// Requirements on a law and n >= 2 (at n = 1 there is no choice):
///   law.left(n, stream)    the left size, 0..n-1
///   law.pmf(n)             P(left = i), i = 0..n-1, each with relative error below 1e-10
///   law.largest_size()     the largest n it can draw
///   Law::uses_table        true where drawing small sizes from an alias table pays (SplitTree)
/// A law is immutable, cheap to copy and compared by value; its constructor refuses parameters out of their
/// domain.
template <class L, class Urbg>
concept SplitLaw = requires(const L& law, Size n, Urbg& stream) {
  { law.left(n, stream) } -> std::same_as<Size>;
  { law.pmf(n) } -> std::same_as<std::vector<double>>;
  { law.largest_size() } -> std::same_as<Size>;
  { L::uses_table } -> std::convertible_to<bool>;
};

}  // namespace ramify
