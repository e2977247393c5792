#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

struct ModelInfo;

/// The complete k-ary tree of n levels, external nodes on the last (A25): k^(n-1) external and (k^(n-1) -
/// 1)/(k-1) internal nodes.
class Kary {
 public:
  using Label = Size;
  static constexpr std::string_view label_meaning = "levels from it on";

  /// @param k  2 to 1000, whole. Throws Error.
  explicit Kary(double k);

  Label root(Size n) const { return n; }

  template <class Urbg>
  void children(Label levels, Urbg&, std::vector<Label>& below) const {
    if (levels > 1) below.insert(below.end(), k_, levels - 1);
  }

  double expected_nodes(Size n) const {
    const auto k = static_cast<double>(k_);
    return (std::pow(k, static_cast<double>(n)) - 1) / (k - 1);
  }

  std::size_t largest_order(Size n) const { return n == 0 ? 0 : n - 1; }
  Size largest_size() const { return 62; }

  static const ModelInfo& info();

 private:
  std::size_t k_;
};

}  // namespace ramify
