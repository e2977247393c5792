#pragma once

#include <string_view>
#include <vector>

#include "ramify/model/split_law.hpp"
#include "ramify/random/variates.hpp"
#include "ramify/tree/grammar.hpp"
#include "ramify/tree/largest_order.hpp"

namespace ramify {

/// Ternary split tree of the white fir and the sugar maple (A22, A23): of the n-1 other internal nodes X go
/// to the third child, max(X-1, 0) to the second and the rest to the first, the main one, X ~ Bin(n,p) given
/// that the rest is not negative (the literal law where it exists, X15). Kruszewski 1996, 3.3.3.
class Ternary {
 public:
  using Label = Size;
  static constexpr std::string_view label_meaning = "internal nodes from it down";

  /// @param p  0 < p <= 1/3, or the first child would not be the main one. Throws Error.
  explicit Ternary(double p);

  Label root(Size n) const { return n; }

  template <class Urbg>
  void children(Label n, Urbg& stream, std::vector<Label>& below) const {
    if (n == 0) return;
    Size third = 0;
    do {
      third = binomial_variate(stream, n, p_);
    } while (third > n / 2);
    const Size second = third > 0 ? third - 1 : 0;
    below.insert(below.end(), {n - 1 - second - third, second, third});
  }

  double expected_nodes(Size n) const { return 3 * static_cast<double>(n) + 1; }
  std::size_t largest_order(Size n) const { return largest_strahler_order(2 * n + 1); }
  Size largest_size() const { return max_double_size; }

  static const ModelInfo& info();

 private:
  double p_;
};

}  // namespace ramify
