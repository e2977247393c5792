#pragma once

#include <span>
#include <vector>

#include "ramify/model/registry.hpp"

namespace ramify {

/// How the n-1 other nodes of a tree of size n divide, up to reflection: no statistic here tells left from
/// right.
struct SplitRow {
  Size n = 0;
  Size first = 0;                   ///< the smallest size of the smaller child that has a weight
  std::span<const double> weights;  ///< P(smaller child = first + m); they sum to 1

  Size smaller(std::size_t m) const { return first + m; }
  Size larger(std::size_t m) const { return n - 1 - smaller(m); }
};

/// The split rows of a model, one size after another: memory O(n).
///
/// Weights below 1e-18 at either end of a row are dropped and the rest is scaled to sum 1, so a row of a
/// binomial law has O(sqrt n) entries. Laws built on the rows are therefore right to 1e-15 in absolute terms;
/// probabilities far below that are not resolved.
class SplitRows {
 public:
  explicit SplitRows(const Model& model) : law_(model.law()) {}

  /// The row of size n >= 1; valid until the next call. O(n), for beta two incomplete betas an entry.
  SplitRow row(Size n);

 private:
  AnySplitLaw law_;
  std::vector<double> weights_;
};

/// The split rows of a model, kept: several laws of one model read them without computing them again.
/// Memory O(n^2), 2 bytes times n^2 at most: 32 MB at n = 4096.
class StoredSplitRows {
 public:
  explicit StoredSplitRows(const Model& model) : rows_(model) {}

  /// The row of size n >= 1, and on the first call all rows below it; valid until the next call.
  SplitRow row(Size n);

 private:
  struct Place {
    Size first;
    std::size_t begin;
  };

  SplitRows rows_;
  std::vector<Place> places_;
  std::vector<double> weights_;
};

}  // namespace ramify
