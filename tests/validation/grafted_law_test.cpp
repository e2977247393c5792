// Graft tables and large grown trees against the laws at their size: the order, and apart from it the height,
// of 10,000 grafted trees of 10^6 nodes, 2,000 of 10^9 and 100 of 10^12, where a tree takes under five
// seconds and the law of the height is in reach.

#include <array>
#include <string>
#include <vector>

#include "support/large_graft.hpp"

namespace ramify {
namespace {

class GraftedTrees : public testing::TestWithParam<test::LargeGraft> {};

TEST_P(GraftedTrees, HaveTheLawOfTheirSize) {
  test::expect_the_large_law(GetParam());
}

/// A model, and as how large trees its statistics are sampled.
struct Validated {
  const char* model;
  const char* neighbour;
  Size largest_of_order, largest_of_height;
};

constexpr Size million = 1'000'000, milliard = 1'000'000'000, billion = 1'000'000'000'000;

const std::vector<Validated> validated{{"bst", "beta(1.1,1.1)", billion, milliard},
                                       {"beta(2,2)", "beta(2.2,2.2)", milliard, milliard},
                                       {"patricia(0.23)", "patricia(0.235)", billion, milliard},
                                       {"dst(0.23)", "dst(0.235)", billion, milliard},
                                       {"catalan", "aldous(-1.45)", milliard, million},
                                       {"aldous(-1)", "aldous(-0.95)", milliard, milliard}};

std::vector<test::LargeGraft> grafts() {
  struct Sampled {
    Size n;
    std::uint64_t trees;
  };
  std::vector<test::LargeGraft> all;
  for (const auto& [n, trees] : {Sampled{million, 10'000}, {milliard, 2000}, {billion, 100}})
    for (const auto& [model, neighbour, largest_of_order, largest_of_height] : validated) {
      if (n <= largest_of_order) all.push_back({model, neighbour, "strahler", n, trees});
      if (n <= largest_of_height) all.push_back({model, neighbour, "height", n, trees});
    }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, GraftedTrees, testing::ValuesIn(grafts()), [](const auto& instance) {
  const std::string model = instance.param.model;
  const int zeros = static_cast<int>(std::log10(static_cast<double>(instance.param.n)));
  return fmt::format("{}_{}_1e{}", model.substr(0, model.find('(')), instance.param.statistic, zeros);
});

}  // namespace
}  // namespace ramify
