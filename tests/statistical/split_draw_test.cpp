#include <iostream>

#include "support/goodness.hpp"
#include "support/growing.hpp"
#include "support/model_cases.hpp"
#include "support/seed.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify {
namespace {

constexpr std::uint64_t split_draws = 400000;
constexpr Size largest_with_every_slip = 300;
constexpr double coarse = static_cast<double>(split_draws) / 64;  // cells that see a shift of the whole law

class SplitDraw : public ::testing::TestWithParam<test::ModelCase> {
 protected:
  void check(Size n, Size table_size) {
    const auto& model = GetParam();
    const auto counts = test::count_splits(model.model, n, split_draws,
                                           test::seed_of("splits of " + model.model), table_size);
    const auto what = fmt::format("{}, left of n = {}{}", model.model, n, n <= table_size ? ", table" : "");
    const auto law = model.law(n);
    EXPECT_TRUE(test::agrees(test::chi_square(what + ", fine", counts, law)));
    EXPECT_TRUE(test::agrees(test::chi_square(what + ", coarse", counts, law, coarse)));
    for (const auto& [slip, wrong] : model.wrong)
      expect_rejected(test::chi_square(what + ": " + slip, counts, wrong(n), coarse, law), n);
  }

  /// Some slips are right as n grows (PATRICIA splits for binomial ones): they are told apart at smaller
  /// sizes.
  static void expect_rejected(const test::Goodness& slip, Size n) {
    if (n > largest_with_every_slip && test::least_power(slip) < test::needed_power)
      std::cout << "  undecided " << slip.what << ": too few draws\n";
    else
      EXPECT_TRUE(test::rejected(slip));
  }
};

TEST_P(SplitDraw, FromTheLargestTable) {
  check(128, test::default_tables);
}
TEST_P(SplitDraw, FromTheLawAtTheSameSize) {
  check(128, test::no_tables);
}
TEST_P(SplitDraw, JustAboveTheTables) {
  check(129, test::default_tables);
}
TEST_P(SplitDraw, AtThreeHundred) {
  check(300, test::default_tables);
}
TEST_P(SplitDraw, AtFiveThousand) {
  check(5000, test::default_tables);
}

INSTANTIATE_TEST_SUITE_P(Models, SplitDraw, ::testing::ValuesIn(test::model_cases()),
                         [](const auto& instance) { return test::name_of(instance.param); });

}  // namespace
}  // namespace ramify
