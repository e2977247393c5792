#pragma once

#include "ramify/model/aldous.hpp"
#include "ramify/model/beta_multinomial.hpp"
#include "ramify/model/chain.hpp"
#include "ramify/model/split_law.hpp"
#include "ramify/random/uniform.hpp"

namespace ramify {

/// Ford's alpha model: of its m = n+1 leaves, k = 1..n go left (left = k-1) with probability
///   G(k) G(m-k) / G(m) [(alpha/2) C(m,k) + (1 - 2 alpha) C(m-2,k-1)],
///   G(m) = (1-alpha) (2-alpha) ... (m-1-alpha).
/// 0 <= alpha <= 1, n <= 2^50. Ford 2005.
///
/// Leaf by leaf: a new one grows out of an edge, of weight 1-alpha where that ends in a leaf, else alpha, the
/// one above the root among these. 0 is the BST (the Yule tree), 1/2 catalan, 1 in the limit the chain;
/// depths grow like n^alpha.
class Ford {
 public:
  static constexpr Size largest_size() { return max_double_size; }
  static constexpr bool uses_table = true;

  /// Throws Error unless 0 <= alpha <= 1.
  explicit Ford(double alpha);

  double alpha() const { return alpha_; }

  /// C(m,k) G(k) G(m-k) is aldous(-1-alpha), C(m-2,k-1) G(k) G(m-k) beta_multinomial(1-alpha,1-alpha). To
  /// alpha = 1/2 the law is their mixture; above, the first, rejected where k (m-k) is large: a third and
  /// more of all tries succeed. O(1) expected.
  template <class Urbg>
  Size left(Size n, Urbg& stream) const {
    if (alpha_ == 1) return Chain().left(n, stream);
    const Aldous lopsided(-1 - alpha_);
    if (alpha_ <= 0.5) {
      if (uniform_open(stream) >= even_share(n)) return lopsided.left(n, stream);
      return BetaMultinomial(1 - alpha_, 1 - alpha_).left(n, stream);
    }
    for (;;) {
      const Size left = lopsided.left(n, stream);
      if (uniform_open(stream) * alpha_ / 2 < bracket(left, n)) return left;
    }
  }

  /// All of it: both ends are modes. Relative error below 1e-10 (BetaBinomial). O(n).
  WeightWindow window(Size n, double cutoff) const;

  SplitCharacter character() const;
  RealSplit real_split() const;
  static const ModelInfo& info();

  friend bool operator==(const Ford&, const Ford&) = default;

 private:
  /// The bracket over C(m,k): alpha/2 + (1 - 2 alpha) k (m-k) / (m (m-1)).
  double bracket(Size left, Size n) const {
    return bracket_of_leaves(static_cast<double>(left) + 1, static_cast<double>(n - left));
  }
  double bracket_of_leaves(double left, double right) const {
    const double all = left + right;
    return alpha_ / 2 + (1 - 2 * alpha_) * (left / all) * (right / (all - 1));
  }

  /// The probability of the second term, alpha <= 1/2: the product of 1 - alpha/(i-alpha) over i = 1..n.
  double even_share(Size n) const;

  double alpha_;
};

}  // namespace ramify
