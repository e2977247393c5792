#pragma once

#include <vector>

#include "ramify/text/csv_reader.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify {

/// P(left = i) of a tree of size n.
struct SplitProbability {
  Size n;
  Size left;
  double probability;
};

/// The split laws of all sizes 1..N from the columns n, left, probability: ordered by n, then left, without
/// those of probability 0, each size scaled to sum 1.
///
/// Throws Error as TabulatedSplit::read says.
std::vector<SplitProbability> read_split_table(const CsvData& csv);

}  // namespace ramify
