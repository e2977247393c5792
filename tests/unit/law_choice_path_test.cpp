#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ramify/law/choice_path.hpp"

namespace ramify {
namespace {

using Weights = std::vector<Size>;

TEST(ChoicePath, GoesEveryWayOnceWithItsProbability) {
  // The second choice is made only where the first took 0.
  ChoicePath path;
  std::map<std::string, double> ways;
  do {
    path.restart();
    std::string way = std::to_string(path.choose(Weights{1, 0, 3}, 4));
    if (way == "0") way += std::to_string(path.choose(Weights{0, 1, 1}, 2));
    EXPECT_FALSE(ways.contains(way)) << way;
    ways[way] = path.probability();
  } while (path.next());
  EXPECT_EQ(ways, (std::map<std::string, double>{{"01", 0.125}, {"02", 0.125}, {"2", 0.75}}));
}

TEST(ChoicePath, HasOneWayWhereThereIsNoChoice) {
  ChoicePath path;
  path.restart();
  EXPECT_EQ(path.probability(), 1);
  EXPECT_FALSE(path.next());
}

TEST(ChoicePath, ForgetsWhatItIsToldTo) {
  ChoicePath path;
  path.restart();
  EXPECT_EQ(path.choose(Weights{1, 1}, 2), 0u);
  path.clear();
  path.restart();
  EXPECT_EQ(path.choose(Weights{0, 5}, 5), 1u);
  EXPECT_EQ(path.probability(), 1);
}

}  // namespace
}  // namespace ramify
