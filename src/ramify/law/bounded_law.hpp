#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

#include "ramify/core/contract.hpp"
#include "ramify/law/moments.hpp"
#include "ramify/law/split_rows.hpp"
#include "ramify/statistic/horton_strahler.hpp"

namespace ramify {

/// The distribution of a statistic of one subtree, as a join reads it: indices -1..K+1 are valid.
struct BoundedPmf {
  const double* at;     ///< at[k] = P(V = k)
  const double* below;  ///< below[k] = P(V < k)
  const double* from;   ///< from[k] = P(V >= k)
};

/// The exact law of a statistic with values 0..floor(log2(n+1)), for every size 0..n: the fold over
/// distributions.
///
/// Join::add(weight, smaller, larger, same_size, top, out) adds to out[0..top] the weight times the law of
/// the joined value, given the laws of two independent children, as sums of products of probabilities:
/// nothing is subtracted. Rows are rescaled to sum 1, so rounding does not grow with n. Absolute error of a
/// probability about 1e-15. Memory O(n log n), time O(n^2 log n).
template <class Join>
class BoundedLaw {
 public:
  /// Room for the sizes 0..largest_n; at first only size 0 is known.
  explicit BoundedLaw(Size largest_n) : top_(HortonStrahler::largest_order(largest_n)), stride_(top_ + 3) {
    for (auto* table : {&at_, &below_, &from_}) table->reserve((largest_n + 1) * stride_);
    std::vector<double> external(top_ + 1, 0.0);
    external[0] = 1;
    append(external);
  }

  /// The sizes 0..sizes()-1 are known.
  Size sizes() const { return at_.size() / stride_; }

  /// Adds the size row.n == sizes().
  void extend(const SplitRow& row) {
    RAMIFY_EXPECTS(row.n == sizes());
    std::vector<double> out(top_ + 1, 0.0);
    const std::size_t top = HortonStrahler::largest_order(row.n);
    for (std::size_t m = 0; m < row.weights.size(); ++m) {
      const Size smaller = row.smaller(m), larger = row.larger(m);
      Join::add(row.weights[m], law(smaller), law(larger), smaller == larger,
                static_cast<std::ptrdiff_t>(top), out.data());
    }
    append(out);
  }

  /// P(V = k), k = 0..K, of a tree of size n < sizes(), K of the largest size.
  std::span<const double> pmf(Size n) const { return {at_.data() + n * stride_ + 1, top_ + 1}; }

  /// P(V = k) and its cumulated forms with room for k = -1 and K+1.
  BoundedPmf law(Size n) const {
    RAMIFY_EXPECTS(n < sizes());
    const std::size_t zero = n * stride_ + 1;
    return {at_.data() + zero, below_.data() + zero, from_.data() + zero};
  }

  Moments moments(Size n) const {
    const auto probabilities = pmf(n);
    double mean = 0, variance = 0;
    for (std::size_t k = 0; k < probabilities.size(); ++k) mean += static_cast<double>(k) * probabilities[k];
    for (std::size_t k = 0; k < probabilities.size(); ++k) {
      const double deviation = static_cast<double>(k) - mean;
      variance += deviation * deviation * probabilities[k];
    }
    return {mean, variance};
  }

 private:
  void append(const std::vector<double>& weights) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const std::size_t zero = at_.size() + 1;
    for (auto* table : {&at_, &below_, &from_}) table->resize(table->size() + stride_, 0.0);
    for (std::size_t k = 0; k <= top_; ++k) at_[zero + k] = weights[k] / sum;
    for (std::size_t k = 0; k <= top_; ++k)
      below_[zero + k + 1] = std::min(1.0, below_[zero + k] + at_[zero + k]);
    for (std::size_t k = top_ + 1; k-- > 0;)
      from_[zero + k] = std::min(1.0, from_[zero + k + 1] + at_[zero + k]);
    from_[zero - 1] = 1;
  }

  std::size_t top_;
  std::size_t stride_;
  std::vector<double> at_, below_, from_;
};

}  // namespace ramify
