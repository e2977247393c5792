// What a tree is worth beside Yule and uniform trees of its size.
#include <cmath>
#include <map>
#include <string>

#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/measure/norms_table.hpp"

namespace ramify {
namespace {

/// The fields of the row of a statistic.
std::map<std::string, std::string> norms_of(const char* word, const std::string& statistic) {
  const Table table = norms_table({measure_all(test::tree_of(word))});
  std::map<std::string, std::string> fields;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (to_text(table.row(i)[2]) != statistic) continue;
    for (std::size_t c = 0; c < table.columns().size(); ++c)
      fields[table.columns()[c]] = to_text(table.row(i)[c]);
  }
  return fields;
}

// n = 3: a chain has a Sackin index of 9, a complete tree 8. Yule trees are chains with probability 2/3,
// uniform trees with 4/5.
TEST(Norms, OfAChainOfThree) {
  const auto chain = norms_of("(E(E(EE)))", "sackin");
  EXPECT_EQ(chain.at("n"), "3");
  EXPECT_EQ(chain.at("value"), "9");
  EXPECT_NEAR(std::stod(chain.at("yule_mean")), 26.0 / 3, 1e-8);
  EXPECT_NEAR(std::stod(chain.at("yule_deviation")), std::sqrt(2.0) / 3, 1e-8);
  EXPECT_NEAR(std::stod(chain.at("yule_z")), 1 / std::sqrt(2.0), 1e-8);
  EXPECT_NEAR(std::stod(chain.at("yule_normalised")), 1.0 / 12, 1e-8);
  EXPECT_NEAR(std::stod(chain.at("uniform_mean")), 8.8, 1e-8);
  EXPECT_NEAR(std::stod(chain.at("uniform_deviation")), 0.4, 1e-8);
  EXPECT_NEAR(std::stod(chain.at("uniform_z")), 0.5, 1e-8);
  EXPECT_NEAR(std::stod(chain.at("uniform_normalised")), 9.0 / 8, 1e-8);
}

TEST(Norms, AreEmptyWhereAllTreesAreAlikeAndNotScaledWhereTheLiteratureHasNoScale) {
  const auto fork = norms_of("(EE)", "total_cophenetic");
  EXPECT_EQ(fork.at("yule_mean"), "0");
  EXPECT_EQ(fork.at("yule_z"), "");
  EXPECT_EQ(fork.at("yule_normalised"), "");
}

TEST(Norms, HaveNoRowsOfTreesWithNodesOfThreeChildren) {
  EXPECT_TRUE(norms_of("((EEE)E)", "sackin").empty());
  EXPECT_TRUE(norms_of("(E(EE))", "depth").empty());
}

}  // namespace
}  // namespace ramify
