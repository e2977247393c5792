#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

#include "ramify/model/real_split.hpp"
#include "ramify/model/split_character.hpp"
#include "ramify/model/weight_window.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

struct ModelInfo;

/// Sizes up to 2^50: above, a double no longer reaches every index 0..n-1.
inline constexpr Size max_double_size = Size{1} << 50;

/// How the n-1 other internal nodes of a split tree of size n divide between left and right.
///
/// Requirements on a law and n >= 2 (at n = 1 there is no choice):
///   law.left(n, stream)      the left size, 0..n-1
///   law.window(n, cutoff)    P(left = i), each with relative error below 1e-10, of n >= 1; what is below
///                            cutoff times the mode may be left out, at cutoff 0 nothing that is positive
///   law.character()          what else is known of it: limiting fraction, symmetry, cost and reach
///   law.largest_size()       the largest n it can draw
///   Law::uses_table          true where drawing small sizes from an alias table pays (SplitTree)
///   Law::info()              the model: name, parameters with their domains, source
/// and, where rows of size after size are made faster than windows, a class Law::Rows that is made from a law
/// and has a window(n): P(left = i) up to a factor and, at its choice, up to reflection; where its weights go
/// on between whole numbers, law.real_split(), with which its laws reach sizes of any magnitude (large/). A
/// law is immutable, cheap to copy and compared by value; its constructor refuses parameters out of their
/// domain.
template <class L, class Urbg>
concept SplitLaw = requires(const L& law, Size n, double cutoff, Urbg& stream) {
  { law.left(n, stream) } -> std::same_as<Size>;
  { law.window(n, cutoff) } -> std::same_as<WeightWindow>;
  { law.character() } -> std::same_as<SplitCharacter>;
  { law.largest_size() } -> std::same_as<Size>;
  { L::uses_table } -> std::convertible_to<bool>;
  { L::info() } -> std::same_as<const ModelInfo&>;
};

/// P(left = i), i = 0..n-1, of a law or a Model. O(n).
template <class Law>
std::vector<double> split_pmf(const Law& law, Size n) {
  WeightWindow window = law.window(n, 0);
  if (window.weights.size() == n) return std::move(window.weights);
  std::vector<double> pmf(n, 0.0);
  std::copy(window.weights.begin(), window.weights.end(),
            pmf.begin() + static_cast<std::ptrdiff_t>(window.first));
  return pmf;
}

}  // namespace ramify
