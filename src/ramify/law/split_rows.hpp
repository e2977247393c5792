#pragma once

#include <functional>
#include <vector>

#include "ramify/law/split_row.hpp"
#include "ramify/model/model.hpp"

namespace ramify {

/// The split rows of a model, one size after another: memory O(n).
///
/// Weights below 1e-30 at either end of a row are dropped and the rest is scaled to sum 1, so a row of a
/// binomial law has O(sqrt n) entries. Rare splits make rare trees: what is dropped is a relative 1e-13 of a
/// probability or a mean count of 1e-17 or more (1e-18 lost digits of mean counts of 1e-7, patricia(0.01)).
class SplitRows {
 public:
  explicit SplitRows(const Model& model);

  /// The row of size n >= 1; valid until the next call. O(length of the law's window).
  SplitRow row(Size n);

 private:
  void fold(Size n, const WeightWindow& left);

  std::function<WeightWindow(Size)> left_;  ///< P(left = i) up to a factor and up to reflection
  std::vector<double> weights_;             ///< P(smaller child = smallest_ + m)
  Size smallest_ = 0;
};

/// The split rows of a model, kept: several laws of one model read them without computing them again.
///
/// Memory O(n^2), at most 2 n^2 bytes: 34 MB at n = 4096. Rows that cost no more to
/// compute than to read back are not kept.
class StoredSplitRows {
 public:
  explicit StoredSplitRows(const Model& model);

  /// The row of size n >= 1, and on the first call all rows below it; valid until the next call.
  SplitRow row(Size n);

 private:
  struct Place {
    Size first;
    std::size_t begin;
  };

  SplitRows rows_;
  bool keeps_;
  std::vector<Place> places_;
  std::vector<double> weights_;
};

}  // namespace ramify
