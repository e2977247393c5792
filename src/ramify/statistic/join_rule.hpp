#pragma once

#include <cstddef>
#include <span>

namespace ramify {

/// The forms in which a law's probabilities enter a join, at a value k.
enum class LawForm : std::size_t {
  at,     ///< P(V = k)
  below,  ///< P(V < k)
  from,   ///< P(V >= k)
  any,    ///< 1
};

/// One way to a joined value of k: the smaller child's V in one form at k + smaller_shift, and the larger
/// child's in another at k + larger_shift. Shifts are -1, 0 or 1.
struct JoinTerm {
  LawForm smaller;
  int smaller_shift;
  LawForm larger;
  int larger_shift;
};

/// The ways of a statistic, which exclude each other: P(V = k) of the parent is the sum over them of the
/// product of the children's probabilities. Equal children may join in another way.
struct JoinRule {
  std::span<const JoinTerm> unequal;
  std::span<const JoinTerm> equal;

  /// The same for P(V >= k), k >= 1, of terms `from` and `below` alone: upper tails as sums of positive
  /// products. Empty where V is 1 + the lower of the children's values, whose P(V < k) is that of either
  /// child being below k-1.
  // NOLINTBEGIN(readability-redundant-member-init): -Wextra wants them where an aggregate leaves one out
  std::span<const JoinTerm> upper_unequal = {};
  std::span<const JoinTerm> upper_equal = {};
  // NOLINTEND(readability-redundant-member-init)

  bool takes_the_lower() const { return upper_unequal.empty(); }
  bool tells_ties() const { return unequal.data() != equal.data(); }
};

}  // namespace ramify
