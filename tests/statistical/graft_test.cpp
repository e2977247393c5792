// Grafting changes nothing: grafted trees against the exact laws and against trees that are grown whole, for
// every model and statistic; tables that are off by one size or of another model are found out.

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "support/columns.hpp"
#include "support/goodness.hpp"
#include "support/grafted_trees.hpp"
#include "support/growing.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"
#include "support/split_table_file.hpp"
#include "support/uninterrupted.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/large/stream_counts.hpp"
#include "ramify/law/build_law.hpp"
#include "ramify/law/depth_law.hpp"
#include "ramify/law/exact_means.hpp"
#include "ramify/law/height_law.hpp"
#include "ramify/law/law_limit.hpp"
#include "ramify/sample/graft_tables.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/statistic/order_ratios.hpp"

namespace ramify {
namespace {

using test::sample;

/// P(value = 0), 1, ...
std::vector<double> exact_pmf(const test::Single& single, const Model& model, Size n) {
  const FiniteLaw law = *build_law(model, n, StatisticLaw(single.recurrence(), n)).law(n);
  std::vector<double> from_0(static_cast<std::size_t>(law.first), 0.0);
  from_0.insert(from_0.end(), law.probabilities.begin(), law.probabilities.end());
  return from_0;
}

constexpr Size grown_n = 1024;  // one statistic is grafted at 256, several at 16 and 12
constexpr std::uint64_t grown_trees = 10'000;

void expect_singles_of_the_exact_law_and_of_whole_trees(const Model& model, const std::string& name) {
  const auto& singles = test::singles;
  std::vector<test::Tally> whole(singles.size());
  sample(model, whole_trees(all_but_indices), grown_n, grown_trees, name + " whole",
         [&](const TreeMeasures& m) {
           for (std::size_t i = 0; i < singles.size(); ++i) ++whole[i][{m.*singles[i].value, 0}];
         });
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const test::Single& single = singles[i];
    const std::string what = name + " " + single.name;
    const auto grafted = test::tally_of(model, {single.pass, true}, grown_n, grown_trees, what, single.value);
    EXPECT_TRUE(test::agrees(
        test::chi_square_from_0(what + ", exact law", grafted, exact_pmf(single, model, grown_n))));
    EXPECT_TRUE(test::agrees(test::two_samples(what + ", whole trees", grafted, whole[i])));
  }
}

void expect_joint_passes_of_the_laws_of_whole_trees(const Model& model, const std::string& name) {
  // Pairs, so that what belongs to different trees is not put together.
  using Pair = std::function<std::pair<std::uint64_t, std::uint64_t>(const TreeMeasures&)>;
  const std::vector<std::pair<std::string, Pair>> pairs{
      {"order and height", [](const TreeMeasures& m) { return std::pair{m.strahler, m.height}; }},
      {"streams 2 and nodes 3", [](const TreeMeasures& m) { return std::pair{m.streams[2], m.nodes[3]}; }},
      {"balance and fill", [](const TreeMeasures& m) { return std::pair{m.balance, m.fill_level}; }},
      {"depth and nodes 1", [](const TreeMeasures& m) { return std::pair{m.depth, m.nodes[1] / 8}; }}};
  const auto tallies = [&](SamplingMethod method, const std::string& tag) {
    std::vector<test::Tally> result(pairs.size());
    sample(model, method, grown_n, grown_trees, tag + name, [&](const TreeMeasures& m) {
      ASSERT_EQ(m.size, grown_n);
      for (std::size_t i = 0; i < pairs.size(); ++i) ++result[i][pairs[i].second(m)];
    });
    return result;
  };
  const auto lean = tallies({orders_and_height, true}, "lean"),
             full = tallies({orders_and_paths, true}, "full"),
             whole = tallies(whole_trees(orders_and_paths), "whole");
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string what = name + " " + pairs[i].first;
    EXPECT_TRUE(test::agrees(test::two_samples(what + ", full", full[i], whole[i])));
    if (i >= 2) continue;  // the lean pass knows no balance
    EXPECT_TRUE(test::agrees(test::two_samples(what + ", lean", lean[i], whole[i])));
  }
}

void expect_counts_of_the_exact_means(const Model& model, FoldSet pass, const std::string& name) {
  // So that mean counts are grafted up to 16 or 32.
  const Size size = std::min<Size>(pass == orders_and_height ? 1200 : 8192, law_limit(model));
  std::map<std::string, test::SampleMean> means;
  sample(model, {pass, true}, size, grown_trees, "counts" + name, [&](const TreeMeasures& m) {
    for (std::size_t k = 1; k <= 4; ++k) {
      means[fmt::format("nodes_{}", k)].add(static_cast<double>(m.nodes[k]));
      means[fmt::format("streams_{}", k)].add(static_cast<double>(m.streams[k]));
    }
  });
  const ExactMeans exact(model, size);
  for (const auto& [column, mean] : means)
    EXPECT_TRUE(test::agrees(
        test::z_test_of_counts(name + " " + column, mean, exact.moments(test::column(column), size)->mean)));
}

class Grafted : public testing::TestWithParam<std::string> {};

TEST_P(Grafted, SinglesHaveTheExactLawAndThatOfWholeTrees) {
  expect_singles_of_the_exact_law_and_of_whole_trees(Model::parse(GetParam()), GetParam());
}

TEST_P(Grafted, JointPassesHaveTheLawsOfWholeTrees) {
  expect_joint_passes_of_the_laws_of_whole_trees(Model::parse(GetParam()), GetParam());
}

TEST_P(Grafted, CountsHaveTheExactMeans) {
  expect_counts_of_the_exact_means(Model::parse(GetParam()), orders_and_height, GetParam());
}

// A third of the way or half of it, whatever n: holes in every row, and nothing that is symmetric.
TEST(GraftedTable, HasTheLawsOfWholeTrees) {
  std::string text = "n,left,probability\n2,0,1\n";
  for (Size size = 3; size <= grown_n; ++size)
    text += fmt::format("{0},{1},0.3\n{0},{2},0.7\n", size, size / 3 - 1, size / 2);
  const test::SplitTableFile file(text);
  expect_singles_of_the_exact_law_and_of_whole_trees(file.model(), "table");
  expect_joint_passes_of_the_laws_of_whole_trees(file.model(), "table");
  expect_counts_of_the_exact_means(file.model(), orders_and_height, "table");
}

INSTANTIATE_TEST_SUITE_P(Every, Grafted, testing::ValuesIn(test::all_models()), [](const auto& instance) {
  std::string name = instance.param.substr(0, instance.param.find('('));
  return name + std::to_string(instance.index);
});

// ---- mean counts ----

constexpr Size averaged_n = 1 << 18;  // subtrees are averaged up to 512, the larger of them from the grid
constexpr std::uint64_t averaged_trees = 1500;

struct RatioSample {
  test::SampleMean ratio, square;  ///< streams mean ratio, and its squared distance from `centre`
  test::Tally orders;
};

RatioSample sample_ratios(const Model& model, FoldSet pass, double centre, const std::string& tag) {
  RatioSample result;
  sample(model, {pass, true}, averaged_n, averaged_trees, tag, [&](const TreeMeasures& m) {
    const double ratio = order_ratios(std::span(m.streams).first(m.strahler + 1)).mean_ratio;
    result.ratio.add(ratio);
    result.square.add((ratio - centre) * (ratio - centre));
    ++result.orders[{m.strahler, 0}];
  });
  return result;
}

test::Goodness difference(const std::string& what, const test::SampleMean& a, const test::SampleMean& b) {
  const double z = (a.mean() - b.mean()) / std::hypot(a.standard_error(), b.standard_error());
  return {what, z, 0, std::erfc(std::abs(z) / std::sqrt(2.0))};
}

class MeanCountsOf : public testing::TestWithParam<const char*> {};

TEST_P(MeanCountsOf, HaveTheExactMeans) {
  expect_counts_of_the_exact_means(Model::parse(GetParam()), orders_and_mean_counts, GetParam());
}

// Order, ratio and its spread, which the averaging of the low orders hardly touches.
TEST_P(MeanCountsOf, LeaveTheRatiosOfTrees) {
  const Model model = Model::parse(GetParam());
  const std::string name = GetParam();
  const auto centre = sample_ratios(model, orders_and_height, 0, name + " centre").ratio.mean();
  const auto counted = sample_ratios(model, orders_and_height, centre, name + " counted");
  const auto averaged = sample_ratios(model, orders_and_mean_counts, centre, name + " averaged");
  EXPECT_TRUE(test::agrees(test::two_samples(name + " order", counted.orders, averaged.orders)));
  EXPECT_TRUE(test::agrees(difference(name + " ratio", counted.ratio, averaged.ratio)));
  EXPECT_TRUE(test::agrees(difference(name + " spread", counted.square, averaged.square)));
}

// Where most of what is grafted comes from the grid: orders by their law, counts by their means.
TEST_P(MeanCountsOf, FromTheGridHaveTheLargeLaws) {
  constexpr Size size = Size{1} << 22;  // averaged up to 8192
  const Model model = Model::parse(GetParam());
  const StreamCounts law = stream_counts(model, size);
  std::vector<test::SampleMean> streams(law.orders());
  std::vector<std::uint64_t> orders(law.orders());
  sample(model, {orders_and_mean_counts, true}, size, 4000, std::string("grid ") + GetParam(),
         [&](const TreeMeasures& m) {
           for (std::size_t k = 0; k < streams.size(); ++k) streams[k].add(static_cast<double>(m.streams[k]));
           ++orders[m.strahler];
         });
  std::vector<double> expected;
  for (std::size_t s = 0; s < law.orders(); ++s)
    expected.push_back(law.order_tail[s] - law.order_tail[s + 1]);
  const std::string name = GetParam();
  EXPECT_TRUE(test::agrees(test::chi_square(name + " order", orders, expected)));
  for (std::size_t k = 1; k < streams.size(); ++k)
    if (law.means[k] > 1) {
      EXPECT_TRUE(test::agrees(
          test::z_test_of_counts(fmt::format("{} streams_{}", name, k), streams[k], law.means[k])));
    }
}

TEST(MeanCounts, OfTheNextModelAreFoundOut) {
  const auto right = sample_ratios(Model::parse("patricia(0.30)"), orders_and_mean_counts, 0, "right");
  const auto wrong = sample_ratios(Model::parse("patricia(0.29)"), orders_and_mean_counts, 0, "wrong");
  EXPECT_TRUE(test::rejected(difference("p = 0.30 and 0.29", right.ratio, wrong.ratio)));
}

INSTANTIATE_TEST_SUITE_P(Fitted, MeanCountsOf,
                         testing::Values("patricia(0.3)", "patricia(0.15)", "dst(0.23)", "bst"));

// ---- tables that are wrong ----

using OrderTable = GraftTable<HortonStrahler::Value, TallyOf<HortonStrahler>>;

/// Orders and counts of a model, each size holding the law of the size `shift` away.
OrderTable order_table(const std::string& text, Size largest, int shift) {
  const auto laws =
      outcome_laws(Model::parse(text), largest + 1, [](ChoicePath&) { return HortonStrahler(); });
  OrderTable table;
  for (Size n = 0; n <= largest; ++n)
    table.append(laws[n <= 1 ? n : static_cast<Size>(static_cast<int>(n) + shift)]);
  return table;
}

/// (order, nodes of order 1) of trees of size 40 of a model, grafted from a table up to size 6.
test::Tally grow_on(const std::string& text, const OrderTable* table, const std::string& tag) {
  constexpr Size n = 40, grafted = 6;
  const Model model = Model::parse(text);
  test::Tally tally;
  std::visit(
      [&]<class Law>(const Law& law) {
        const SplitTree<Law> grammar(law);
        Grower<SplitTree<Law>, HortonStrahler, Stream> grower(test::uninterrupted);
        for (std::uint64_t replicate = 0; replicate < test::replicates(40'000); ++replicate) {
          Stream stream({test::seed_of(tag), n}, replicate);
          HortonStrahler fold;
          const auto order = table == nullptr ? grower(grammar, n, stream, fold)
                                              : grower(grammar, n, stream, fold, Graft(*table, grafted));
          ++tally[{order, fold.nodes()[1]}];
        }
      },
      model.law());
  return tally;
}

TEST(GraftTable, ThatIsOffByOneSizeIsFoundOut) {
  for (const char* text : {"bst", "catalan", "patricia(0.23)", "beta(2,5)"}) {
    const auto whole = grow_on(text, nullptr, fmt::format("{} whole", text));
    for (const int shift : {-1, 0, 1}) {
      const OrderTable table = order_table(text, 6, shift);
      const auto what = fmt::format("{}, table shifted by {}", text, shift);
      const auto goodness = test::two_samples(what, grow_on(text, &table, what), whole);
      EXPECT_TRUE(shift == 0 ? test::agrees(goodness) : test::rejected(goodness));
    }
  }
}

TEST(GraftTable, OfTheWrongModelIsFoundOut) {
  for (const auto& [text, wrong] : {std::pair{"patricia(0.23)", "dst(0.23)"}, std::pair{"bst", "beta(2,2)"},
                                    std::pair{"catalan", "bst"}, std::pair{"dst(0.23)", "dst(0.3)"}}) {
    const auto whole = grow_on(text, nullptr, fmt::format("{} grown whole", text));
    const OrderTable table = order_table(wrong, 6, 0);
    const auto what = fmt::format("{} on a table of {}", text, wrong);
    EXPECT_TRUE(test::rejected(test::two_samples(what, grow_on(text, &table, what), whole)));
  }
}

}  // namespace
}  // namespace ramify
