#pragma once

#include "ramify/law/moments.hpp"
#include "ramify/law/size_series.hpp"

namespace ramify {

/// Exact mean and variance of a sum over the nodes of a tree of what each one's split costs, for every size
/// 0..n (B23).
///
/// Y(n) = Y(L) + Y(R) + c(L, R), Y(0) = 0, the children independent given their sizes, so E Y is the mean
/// over the splits of the right side, and Var Y that of Var Y(L) + Var Y(R) plus the variance over the splits
/// of E Y(L) + E Y(R) + c. Sums of positive terms: relative error about 1e-13. Memory O(n), time O(n^2), for
/// rows of n entries.
class NodeSumLaw {
 public:
  enum class Of {
    path_length,  ///< c = n - 1
    sackin,       ///< c = n + 1
    colless,      ///< c = |L - R|
  };

  explicit NodeSumLaw(Of of);

  Size sizes() const { return sizes_; }

  /// Adds the size row.n == sizes().
  void extend(const SplitRow& row);

  Moments moments(Size n) const { return {mean_[n], variance_[n]}; }

 private:
  double cost(const SplitRow& row, std::size_t m) const;

  Of of_;
  Size sizes_ = 1;
  SizeSeries mean_, variance_;
};

}  // namespace ramify
