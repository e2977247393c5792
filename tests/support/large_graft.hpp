#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "support/grafted_trees.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/large/large_law.hpp"
#include "ramify/model/registry.hpp"

namespace ramify::test {

/// Grafted trees to be held against the law at their size.
struct LargeGraft {
  const char* model;
  const char* neighbour;  ///< of a parameter next to it: a law that may have to be rejected
  const char* statistic;  ///< strahler or height
  Size n;
  std::uint64_t trees;

  friend std::ostream& operator<<(std::ostream& out, const LargeGraft& graft) {
    return out << graft.trees << " trees of " << graft.model << ", n = " << graft.n << ", "
               << graft.statistic;
  }
};

/// P(value = 0), 1, ... at any size up to the largest.
class LargePmf {
 public:
  LargePmf(const char* model, const Single& single, double largest)
      : law_(Model::parse(model), single.recurrence(), {largest}, uninterrupted) {}

  std::vector<double> operator()(double n) const {
    const LargeFiniteLaw law = *law_.law(n);
    std::vector<double> from_0(static_cast<std::size_t>(law.first), 0.0);
    for (const Approximation& p : law.probabilities) from_0.push_back(p.value);
    return from_0;
  }

 private:
  LargeLaw law_;
};

/// Whether so many trees of a law tell it from a wrong one: their expected counts alone, without a tree's
/// scatter, have p < 1e-20 there, so that a sample has p < alpha but for one in a million or so.
inline bool is_told_apart(std::uint64_t trees, const std::vector<double>& right,
                          const std::vector<double>& wrong) {
  Tally expected;
  for (std::size_t k = 0; k < right.size(); ++k) {
    const auto count = static_cast<std::uint64_t>(std::llround(static_cast<double>(trees) * right[k]));
    if (count > 0) expected[{k, 0}] = count;
  }
  return chi_square_from_0("", expected, wrong).p_value < 1e-20;
}

/// The least multiple of n whose law these trees tell from that of n: 1.05 for most.
inline std::optional<double> size_told_apart(const LargeGraft& graft, const LargePmf& pmf,
                                             double largest_factor) {
  const auto n = static_cast<double>(graft.n);
  for (const double factor : {1.05, 1.1, 1.2, 1.5, 2.0, 3.0, 4.0, 6.0})
    if (factor <= largest_factor && is_told_apart(graft.trees, pmf(n), pmf(factor * n))) return factor;
  return std::nullopt;
}

/// The trees agree with the law of their size, and reject that of the nearest larger size which so many trees
/// tell apart (there must be one), and of the neighbouring model where they tell that apart.
inline void expect_the_large_law(const LargeGraft& graft) {
  constexpr double largest_factor = 6;
  const auto single = std::ranges::find(singles, graft.statistic, &Single::name);
  const auto n = static_cast<double>(graft.n);
  const std::string what = fmt::format("{} {} n = {}", graft.model, graft.statistic, graft.n);
  const Tally tally =
      tally_of(Model::parse(graft.model), {single->pass, true}, graft.n, graft.trees, what, single->value);
  const LargePmf pmf(graft.model, *single, largest_factor * n);
  EXPECT_TRUE(agrees(chi_square_from_0(what, tally, pmf(n))));

  const auto factor = size_told_apart(graft, pmf, largest_factor);
  ASSERT_TRUE(factor.has_value()) << what << ": these trees tell no size apart";
  EXPECT_TRUE(rejected(
      chi_square_from_0(fmt::format("{}, of {} n", what, *factor), tally, pmf(*factor * n), pmf(n))));

  const std::vector<double> neighbour = LargePmf(graft.neighbour, *single, n)(n);
  const std::string of_neighbour = fmt::format("{}, of {}", what, graft.neighbour);
  if (is_told_apart(graft.trees, pmf(n), neighbour))
    EXPECT_TRUE(rejected(chi_square_from_0(of_neighbour, tally, neighbour, pmf(n))));
  else
    std::cout << "  undecided " << of_neighbour << ": too few trees\n";
}

}  // namespace ramify::test
