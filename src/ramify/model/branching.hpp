#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "ramify/random/uniform.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

struct ModelInfo;

/// A Galton-Watson branching process limited to n generations (A20): every node of the generations 1..n-1 has
/// 0, 1 or 2 children with probabilities p0, p1, p2, those of generation n none. Kruszewski 1996, 4.2.5. The
/// mean number of children is m = p1 + 2 p2; for m > 1 the process lives for ever with probability 1 - p0/p2
/// only (X29).
class Branching {
 public:
  using Label = Size;
  static constexpr std::string_view label_meaning = "generations from it on, its own counted";

  /// Throws Error unless p0, p1, p2 >= 0 sum to 1 within 1e-9 (they are then scaled to 1).
  Branching(double p0, double p1, double p2);

  Label root(Size n) const { return n; }

  template <class Urbg>
  void children(Label generations, Urbg& stream, std::vector<Label>& below) const {
    if (generations <= 1) return;
    const double u = uniform_open(stream);
    const std::size_t count = u < p0_ ? 0 : u < p0_ + p1_ ? 1 : 2;
    below.insert(below.end(), count, generations - 1);
  }

  /// 1 + m + ... + m^(n-1).
  double expected_nodes(Size n) const {
    const double m = p1_ + 2 * p2_, generations = static_cast<double>(n);
    return m == 1 ? generations : (std::pow(m, generations) - 1) / (m - 1);
  }

  std::size_t largest_order(Size n) const {
    return static_cast<std::size_t>(n == 0 ? 0 : std::min<Size>(n - 1, 62));
  }

  static const ModelInfo& info();

 private:
  double p0_, p1_, p2_;
};

}  // namespace ramify
