// Trees of a ramification matrix: every small tree as often as the matrix says.
#include <string>
#include <vector>

#include "support/goodness.hpp"
#include "support/sanitized.hpp"
#include "support/scratch.hpp"
#include "support/word_law.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify {
namespace {

using test::WordLaw;
using test::words_against;

/// matrix[k-1][j] = p(k,j), leaf order 0; p(k,k) of two children of order k-1.
using Matrix = std::vector<std::vector<double>>;

std::size_t internal_nodes_of(const std::string& word) {
  std::size_t nodes = 0;
  for (const char c : word) nodes += c == '(' ? 1 : 0;
  return nodes;
}

/// The trees of one order with at most `most` internal nodes, by repeating the definition until nothing new
/// comes: a chain of order k is one node longer each time.
WordLaw small_trees(const Matrix& matrix, std::size_t order, std::size_t most) {
  if (order == 0) return {{"E", 1.0}};
  std::vector<WordLaw> lower;
  for (std::size_t j = 0; j < order; ++j) lower.push_back(small_trees(matrix, j, most));
  WordLaw law;
  for (std::size_t step = 0; step <= most; ++step) {
    WordLaw next;
    test::add_node(test::side_by_side({lower[order - 1], lower[order - 1]}), matrix[order - 1][order], next);
    for (std::size_t j = 0; j < order; ++j) {
      test::add_node(test::side_by_side({law, lower[j]}), matrix[order - 1][j] / 2, next);
      test::add_node(test::side_by_side({lower[j], law}), matrix[order - 1][j] / 2, next);
    }
    std::erase_if(next, [&](const auto& entry) { return internal_nodes_of(entry.first) > most; });
    law = std::move(next);
  }
  return law;
}

constexpr std::size_t largest = test::sanitized ? 5 : 7;  // nodes of the trees that are told apart

const char* const first_rows = "order,side,probability\n2,1,0.4\n2,2,0.6\n3,1,0.2\n3,2,0.3\n3,3,0.5\n";
const char* const second_rows = "order,side,probability\n2,1,0.1\n2,2,0.9\n3,1,0.6\n3,2,0.1\n3,3,0.3\n";

TEST(Ramification, HasTheLawOfItsMatrix) {
  const Matrix matrix{{0.4, 0.6}, {0.2, 0.3, 0.5}}, wrong{{0.4, 0.6}, {0.3, 0.2, 0.5}};
  const test::Scratch scratch;
  const auto model = fmt::format("ramification({})", scratch.file("first.csv", first_rows));
  for (const Size order : {Size{0}, Size{1}, Size{2}})
    EXPECT_TRUE(test::agrees(words_against(model, order, small_trees(matrix, order, largest), "")));
  EXPECT_TRUE(test::rejected(words_against(model, 2, small_trees(wrong, 2, largest), ": sides swapped")));
}

TEST(Tokunaga, HasTheLawOfItsNumbers) {
  // T_1 = 1, T_2 = 2: p(1,0) = 1/2, p(2,1) = 1/4, p(2,0) = 2/4.
  const Matrix matrix{{0.5, 0.5}, {0.5, 0.25, 0.25}}, wrong{{0.5, 0.5}, {0.25, 0.5, 0.25}};
  for (const Size order : {Size{1}, Size{2}})
    EXPECT_TRUE(test::agrees(words_against("tokunaga(1,2)", order, small_trees(matrix, order, largest), "")));
  EXPECT_TRUE(
      test::rejected(words_against("tokunaga(1,2)", 2, small_trees(wrong, 2, largest), ": T_1 for T_2")));
}

TEST(Hybrid, TakesEachRowFromTheMatrixNamed) {
  const Matrix ab{{0.4, 0.6}, {0.6, 0.1, 0.3}}, aa{{0.4, 0.6}, {0.2, 0.3, 0.5}};
  const test::Scratch scratch;
  const auto model = fmt::format("hybrid({}, {}, AB)", scratch.file("first.csv", first_rows),
                                 scratch.file("second.csv", second_rows));
  EXPECT_TRUE(test::agrees(words_against(model, 2, small_trees(ab, 2, largest), "")));
  EXPECT_TRUE(
      test::rejected(words_against(model, 2, small_trees(aa, 2, largest), ": all rows of the first")));
}

// Of the transitions 3 -> 1, 2, 3, 4 of 0.1, 0.2, 0.3, 0.4 the first three are kept: 1/6, 2/6, 3/6.
TEST(Markov, KeepsTransitionsDownwards) {
  const char* chain =
      "state,next,probability\n2,1,0.2\n2,2,0.3\n2,3,0.5\n3,1,0.1\n3,2,0.2\n3,3,0.3\n3,4,0.4\n"
      "4,4,1\n";
  const Matrix matrix{{0.4, 0.6}, {1 / 6.0, 2 / 6.0, 3 / 6.0}};
  const Matrix wrong{{0.2, 0.8}, {0.1, 0.2, 0.7}};
  const test::Scratch scratch;
  const auto model = fmt::format("markov({})", scratch.file("chain.csv", chain));
  EXPECT_TRUE(test::agrees(words_against(model, 2, small_trees(matrix, 2, largest), "")));
  EXPECT_TRUE(test::rejected(
      words_against(model, 2, small_trees(wrong, 2, largest), ": what leads up is added to the diagonal")));
}

}  // namespace
}  // namespace ramify
