#pragma once

#include <variant>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// How the left size scatters about nX, X the node's split fraction.
enum class Scatter {
  none,      ///< floor(nX)
  binomial,  ///< Bin(n-1, X)
  strings,   ///< K-1, K ~ Bin(n+1, X) given 1 <= K <= n: no side is without a string, or a leaf
};

/// X has a density proportional to x^(a-1) (1-x)^(b-1), a, b > -1.
///
/// For a, b > 0 that is beta(a,b). Else it is none, but cut off where a side has no leaf left
/// (Scatter::strings) it is a law at every n: X then tends to 0 or 1, and depths grow like n^-min(a,b), or
/// like log^2 n where that is 0.
struct BetaFraction {
  double a;
  double b;
  Scatter scatter;

  bool is_density() const { return a > 0 && b > 0; }
};

/// X = p at every node.
struct ConstantFraction {
  double p;
  Scatter scatter;
};

/// X swings with n: all subtrees of a node but one are perfect.
struct PerfectFraction {};

/// X tends to 0 or 1, otherwise than by a BetaFraction: depths grow like n^e, 0 < e <= 1. Where e is 1, all
/// nodes are on one path.
struct NoFraction {
  double depth_exponent;
};

/// Nothing is known of X.
struct UnknownFraction {};

/// The limiting split fraction of a law: what share of a large tree goes left at its root.
using SplitFraction =
    std::variant<BetaFraction, ConstantFraction, PerfectFraction, NoFraction, UnknownFraction>;

/// e where depths grow like n^e; 0 where they grow like log n, or nothing is known.
double depth_exponent(const SplitFraction& fraction);

/// A size splits in one way, up to reflection: what does not tell left from right is the same in all trees of
/// one size.
bool splits_in_one_way(const SplitFraction& fraction);

/// What the split row of a size takes (law/split_rows.hpp).
struct RowCost {
  double nanoseconds = 4;  ///< to make an entry
  double bytes = 24;       ///< of tables, for each size
};

/// The largest n up to which the exact laws of all statistics together take about 2 s on one core of 2020s
/// server hardware, and up to which OrderMoments take about 1 s besides. Measured once: tables must not
/// depend on the machine.
struct LawReach {
  Size all_laws;
  Size order_moments;
};

/// By how far depths spread.
LawReach reach_of(const BetaFraction& fraction);
LawReach reach_of(const ConstantFraction& fraction);

/// What is known of a split law beyond the law itself.
struct SplitCharacter {
  SplitFraction fraction;
  bool is_symmetric;  ///< left and right alike at every n
  RowCost row;
  LawReach reach;
};

}  // namespace ramify
