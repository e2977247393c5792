#include <map>
#include <string>
#include <vector>

#include "support/definitions.hpp"
#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/model_cases.hpp"
#include "support/seed.hpp"
#include "support/shape.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

/// A shape's probability: the product of the split law over its internal nodes.
double shape_probability(const test::Shape& shape, const std::vector<std::vector<double>>& laws) {
  if (shape.is_external()) return 1;
  const auto& left = shape.children[0];
  const auto& right = shape.children[1];
  return laws[test::internal_nodes(shape)][test::internal_nodes(left)] * shape_probability(left, laws) *
         shape_probability(right, laws);
}

std::vector<double> shape_law(const std::vector<test::Shape>& shapes, std::size_t n,
                              const test::SplitPmf& split) {
  std::vector<std::vector<double>> laws{{}};
  for (Size size = 1; size <= n; ++size) laws.push_back(split(size));
  std::vector<double> law;
  for (const auto& shape : shapes) law.push_back(shape_probability(shape, laws));
  return law;
}

/// How often each shape grew.
std::vector<std::uint64_t> count_shapes(const std::vector<test::Shape>& shapes, std::size_t n,
                                        std::uint64_t trees, const test::TreeSource& grow) {
  std::map<std::string, std::size_t> place;
  for (const auto& shape : shapes) place.emplace(test::to_word(shape), place.size());
  std::vector<std::uint64_t> counts(shapes.size(), 0);
  for (std::uint64_t replicate = 0; replicate < trees; ++replicate)
    ++counts[place.at(to_parentheses(grow(n, replicate)))];
  return counts;
}

class ShapeLaw : public ::testing::TestWithParam<test::ModelCase> {
 protected:
  static constexpr std::size_t largest = 6;

  void check(Size table_size, const std::string& tag) {
    const auto& model = GetParam();
    for (std::size_t n = 1; n <= largest; ++n) {
      const auto shapes = test::all_shapes(n);
      const auto grow = test::tree_source(model.model, {test::seed_of(model.model + tag), n}, table_size);
      const auto counts = count_shapes(shapes, n, n == largest ? 100000 : 20000, grow);
      const auto what = fmt::format("{}, shapes of n = {}, {}", model.model, n, tag);
      EXPECT_TRUE(test::agrees(test::chi_square(what, counts, shape_law(shapes, n, model.law))));
      if (n < largest) continue;
      for (const auto& list : {model.wrong, model.wrong_when_small})
        for (const auto& [slip, law] : list)
          EXPECT_TRUE(
              test::rejected(test::chi_square(what + ": " + slip, counts, shape_law(shapes, n, law))));
    }
  }
};

TEST_P(ShapeLaw, HoldsForDrawsFromTables) {
  check(test::default_tables, "from tables");
}

TEST_P(ShapeLaw, HoldsForDrawsFromTheLaw) {
  check(test::no_tables, "from the law");
}

INSTANTIATE_TEST_SUITE_P(Models, ShapeLaw, ::testing::ValuesIn(test::model_cases()),
                         [](const auto& instance) { return test::name_of(instance.param); });

}  // namespace
}  // namespace ramify
