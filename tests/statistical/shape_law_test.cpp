#include <string>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/model_cases.hpp"
#include "support/seed.hpp"
#include "support/shape.hpp"
#include "support/shape_counts.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

class ShapeLaw : public ::testing::TestWithParam<test::ModelCase> {
 protected:
  static constexpr std::size_t largest = 7;
  static constexpr std::size_t controlled = 6;  // where the mistakes are looked for
  static constexpr double least_expected = 5;

  void check(Size table_size, const std::string& tag) {
    const auto& model = GetParam();
    for (std::size_t n = 1; n <= largest; ++n) {
      const auto shapes = test::all_shapes(n);
      const auto grow = test::tree_source(model.model, {test::seed_of(model.model + tag), n}, table_size);
      const auto counts =
          test::count_shapes(shapes, n == controlled ? 100000 : 20000,
                             [&](std::uint64_t replicate) { return to_parentheses(grow(n, replicate)); });
      const auto what = fmt::format("{}, shapes of n = {}, {}", model.model, n, tag);
      const auto right = test::shape_law(shapes, n, model.law);
      EXPECT_TRUE(test::agrees(test::chi_square(what, counts, right)));
      if (n != controlled) continue;
      for (const auto& list : {model.wrong, model.wrong_when_small})
        for (const auto& [slip, law] : list)
          EXPECT_TRUE(test::rejected(test::chi_square(
              what + ": " + slip, counts, test::shape_law(shapes, n, law), least_expected, right)));
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
