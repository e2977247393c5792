#include <cmath>
#include <numeric>
#include <vector>

#include "support/goodness.hpp"
#include "support/reference_laws.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/random/alias_table.hpp"
#include "ramify/random/stream.hpp"

namespace ramify {
namespace {

using test::agrees;
using test::chi_square;
using test::rejected;
using test::seed_of;

std::vector<AliasCell> table_of(const std::vector<double>& weights) {
  std::vector<AliasCell> cells(weights.size());
  build_alias_cells(weights, cells);
  return cells;
}

/// The probability of every outcome, read off the cells.
std::vector<double> law_of(const std::vector<AliasCell>& cells) {
  std::vector<long double> law(cells.size(), 0);
  const long double m = static_cast<long double>(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const long double keep = static_cast<long double>(cells[i].threshold) * 0x1p-64L;
    law[i] += keep / m;
    law[cells[i].other] += (1 - keep) / m;
  }
  return {law.begin(), law.end()};
}

std::vector<std::vector<double>> some_weights() {
  return {{1},
          {1, 1},
          {1, 0},
          {0, 0, 3},
          {1, 2, 3, 4},
          {1e-300, 1, 1e300},
          {0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1},
          {1, 0, 1, 0, 1, 0, 0},
          test::dst_law(128, 0.23),
          test::patricia_law(128, 0.9),
          test::catalan_law(127),
          test::split_law(100, 0.25),
          test::uniform_law(37)};
}

TEST(AliasTable, HoldsTheWeightsExactly) {
  for (const auto& weights : some_weights()) {
    const auto law = law_of(table_of(weights));
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i)
      EXPECT_NEAR(law[i], weights[i] / sum, 1e-15) << "outcome " << i << " of " << weights.size();
  }
}

TEST(AliasTable, NeverDrawsAnOutcomeOfWeightZero) {
  for (const auto& weights : some_weights()) {
    const auto cells = table_of(weights);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] == 0) {
        EXPECT_EQ(cells[i].threshold, 0u);
      }
      EXPECT_GT(weights[cells[i].other], 0) << "column " << i << " points to an impossible outcome";
    }
  }
}

TEST(AliasTable, DrawsFromTheWeights) {
  const auto weights = test::catalan_law(40);
  const auto cells = table_of(weights);
  Stream stream({seed_of("alias draws"), 0}, 0);
  std::vector<std::uint64_t> counts(weights.size(), 0);
  for (int i = 0; i < 200000; ++i) ++counts.at(draw_alias(std::span<const AliasCell>(cells), stream));
  EXPECT_TRUE(agrees(chi_square("alias draws", counts, weights)));
  EXPECT_TRUE(rejected(chi_square("alias draws, next size's law", counts, test::short_catalan_law(40))));
}

}  // namespace
}  // namespace ramify
