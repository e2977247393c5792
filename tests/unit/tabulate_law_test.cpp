// What `ramify law` is asked for, what it refuses, and what it prints.
#include <cmath>
#include <limits>
#include <sstream>

#include "support/error_of.hpp"
#include "support/growing.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/io/csv_writer.hpp"
#include "ramify/statistic/height.hpp"
#include "ramify/statistic/last_node_depth.hpp"
#include "ramify/statistic/registry.hpp"
#include "ramify/statistic/strahler.hpp"
#include "ramify/tabulate/law_request.hpp"
#include "ramify/tabulate/law_table.hpp"

namespace ramify {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

LawRequest request(std::string_view model, const std::string& statistic, std::vector<double> sizes,
                   LawQuantity quantity = LawQuantity::law) {
  return {Model::parse(model), LawSubject::parse(statistic), quantity, std::move(sizes)};
}

LawRequest exact(LawRequest request) {
  request.exact = true;
  return request;
}

std::string law_refusal(const LawRequest& request, const LawCost& limit) {
  return test::error_of([&] { require_computable(request, limit); });
}

/// The number behind "--n " in a message.
double suggested(const std::string& message) {
  return std::stod(message.substr(message.find("--n ") + 4));
}

std::string subject_refusal(const char* subject) {
  return test::error_of([&] { LawSubject::parse(subject); });
}

TEST(LawSubject, WithoutALawNamesThoseThatHaveOne) {
  EXPECT_NE(
      subject_refusal("size").find("strahler, registers, height, depth, external_depth, fill_level, balance, "
                                   "alternate_balance, orders, path_length, sackin, colless, cherries"),
      std::string::npos)
      << subject_refusal("size");
  EXPECT_NE(subject_refusal("heigth").find("did you mean height"), std::string::npos);
}

TEST(LawSubject, IsEveryStatisticThatIsListedWithALaw) {
  for (const StatisticInfo& info : statistics())
    EXPECT_EQ(subject_refusal(info.name.data()).empty(), known_of(info.law.recurrence) >= Known::moments)
        << info.name;
}

TEST(LawRequest, OfCovariancesIsForOrdersAlone) {
  for (const auto& statistic : law_subjects())
    EXPECT_EQ(law_refusal(request("bst", statistic, {10}, LawQuantity::covariances), {unlimited, unlimited})
                  .empty(),
              statistic == "orders")
        << statistic;
}

TEST(LawRequest, OfASumIsForItsMomentsAlone) {
  for (const auto& statistic : moment_subjects()) {
    const auto refused = [&](LawQuantity quantity) {
      return law_refusal(request("bst", statistic, {10}, quantity), {unlimited, unlimited});
    };
    EXPECT_NE(refused(LawQuantity::law).find("--moments"), std::string::npos) << statistic;
    EXPECT_NE(refused(LawQuantity::covariances), "") << statistic;
    EXPECT_EQ(refused(LawQuantity::moments), "") << statistic;
  }
}

TEST(LawRequest, AboveTheModelsLargestSizeIsRefusedWhateverTheLimit) {
  const double above = 0x1p50 + 1;
  EXPECT_NE(law_refusal(exact(request("catalan", "depth", {10, above, 20})), {unlimited, unlimited})
                .find("sizes up to"),
            std::string::npos);
}

TEST(LawRequest, ThatTakesMoreThanAnHourHasToBeMeant) {
  const LawRequest depth = exact(request("bst", "depth", {500'000}));
  EXPECT_NE(law_refusal(depth, {unlimited, long_law_seconds}).find("add --yes if you mean it"),
            std::string::npos);
  EXPECT_EQ(law_refusal(depth, {unlimited, unlimited}), "");
}

/// Every split model, and parameters that make their rows or their laws very wide or very narrow.
std::vector<std::string> models_and_extremes() {
  std::vector<std::string> models = test::all_models();
  models.insert(models.end(), {"beta(0.01,0.01)", "beta(1e9,1e9)", "beta(1e9,1e-9)", "split(0.01)",
                               "patricia(1e-9)", "aldous(-1.999)", "aldous(-0.999)"});
  return models;
}

class LawLimit : public testing::TestWithParam<std::string> {};

TEST_P(LawLimit, IsKeptAndTheSizeSuggestedIsNearIt) {
  for (const auto& statistic : law_subjects()) {
    for (const LawCost& limit : {LawCost{1e9, unlimited}, LawCost{unlimited, 10}, LawCost{1e8, 100}}) {
      const std::string message = law_refusal(exact(request(GetParam(), statistic, {0x1p40})), limit);
      ASSERT_NE(message, "") << statistic;
      EXPECT_NE(message.find(limit.bytes < unlimited ? "of memory" : "takes about"), std::string::npos)
          << message;
      const double fits = suggested(message);
      EXPECT_EQ(law_refusal(exact(request(GetParam(), statistic, {fits})), limit), "") << message;
      EXPECT_NE(law_refusal(exact(request(GetParam(), statistic, {std::floor(fits * 1.125)})), limit), "")
          << message;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, LawLimit, testing::ValuesIn(models_and_extremes()));

TEST(LawLimit, GrowsWithEverySize) {
  for (const std::string& text : models_and_extremes()) {
    const CountOfOrder counts{OrderCount::Of::nodes};
    for (const LawWork& work : std::vector<LawWork>{{Strahler::recurrence},
                                                    {Height::recurrence},
                                                    {LastNodeDepth::recurrence},
                                                    {counts, true},
                                                    {counts}}) {
      LawCost last{0, 0};
      for (Size n = 1; n <= Size{1} << 50; n *= 2) {
        const LawCost cost = law_cost(Model::parse(text), work, n);
        EXPECT_GT(cost.bytes, last.bytes) << text << ' ' << n;
        EXPECT_GT(cost.seconds, last.seconds) << text << ' ' << n;
        last = cost;
      }
    }
  }
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) found.push_back(line);
  return found;
}

TEST(LawTable, OfEveryStatisticSumsToOneAtEverySize) {
  for (const char* model : {"bst", "split(0.25)", "patricia(0.23)"}) {
    for (const char* statistic : {"strahler", "height", "depth", "fill_level", "balance"}) {
      const auto rows = lines(write_csv(law_table(request(model, statistic, {60, 0, 1, 7}), {})));
      double sum = 0;
      std::vector<std::string> sizes;
      for (std::size_t i = 1; i < rows.size(); ++i) {
        const double probability = std::stod(rows[i].substr(rows[i].rfind(',') + 1));
        EXPECT_GT(probability, 0) << rows[i];
        sum += probability;
        const std::string size = rows[i].substr(rows[i].find(',') + 1, 2);
        if (sizes.empty() || sizes.back() != size) sizes.push_back(size);
      }
      EXPECT_NEAR(sum, 4, 1e-13) << model << ' ' << statistic;
      EXPECT_EQ(sizes, (std::vector<std::string>{"60", "0,", "1,", "7,"})) << model << ' ' << statistic;
    }
  }
}

TEST(LawTable, HeightKeepsItsUpperTail) {
  // A chain of n nodes, left and right freely: 2^(n-1)/n! of a BST.
  const auto rows = lines(write_csv(law_table(request("bst", "height", {14}), {})));
  double chain = 1;
  for (int n = 2; n <= 14; ++n) chain *= 2.0 / n;
  ASSERT_TRUE(rows.back().starts_with("bst,14,height,15,")) << rows.back();
  EXPECT_NEAR(std::stod(rows.back().substr(17)) / chain, 1, 1e-13);
}

TEST(LawTable, MomentsOfOrdersAreThoseOfTheirCounts) {
  const auto rows = lines(write_csv(law_table(request("bst", "orders", {0, 3}, LawQuantity::moments), {})));
  ASSERT_EQ(rows.size(), 9u);
  EXPECT_EQ(rows[1], "bst,0,nodes_0,1,0");
  EXPECT_EQ(rows[2], "bst,0,streams_0,1,0");
  EXPECT_EQ(rows[3], "bst,3,nodes_0,4,0");
  EXPECT_TRUE(rows[4].starts_with("bst,3,nodes_1,2.666666666666")) << rows[4];
  EXPECT_TRUE(rows[8].starts_with("bst,3,streams_2,0.333333333333")) << rows[8];
}

TEST(LawTable, CovariancesAreOfEveryTwoCounts) {
  const auto rows = lines(write_csv(law_table(request("bst", "orders", {3}, LawQuantity::covariances), {})));
  EXPECT_EQ(rows.size(), 1u + 6 * 7 / 2);
  EXPECT_EQ(rows[0], "model,n,leaf_order,first,second,covariance");
  EXPECT_EQ(rows[1], "bst,3,0,nodes_0,nodes_0,0");
  EXPECT_TRUE(rows.back().starts_with("bst,3,0,streams_2,streams_2,0.2222222222222")) << rows.back();
}

// Of size 2 there are chains alone: external nodes at the depths 2, 3, 3, and one internal node below the
// root.
TEST(LawTable, OfExternalDepthsAndSums) {
  const Cancellation never;
  EXPECT_EQ(write_csv(law_table(request("split(0.25)", "external_depth", {2}), never)),
            "model,n,statistic,value,probability\nsplit(0.25),2,external_depth,2,0.3333333333333333\n"
            "split(0.25),2,external_depth,3,0.6666666666666666\n");
  for (const auto& [statistic, mean] :
       {std::pair{"path_length", 1}, std::pair{"sackin", 5}, std::pair{"colless", 1}})
    EXPECT_EQ(write_csv(law_table(request("bst", statistic, {2}, LawQuantity::moments), never)),
              fmt::format("model,n,statistic,mean,variance\nbst,2,{},{},0\n", statistic, mean));
}

TEST(LawRequest, OfADeepModelBeyondItsTimeSaysWhatFits) {
  const LawRequest height = request("catalan", "height", {1e12});
  const std::string message = law_refusal(height, {unlimited, long_law_seconds});
  ASSERT_NE(message.find("take --n"), std::string::npos) << message;
  EXPECT_EQ(law_refusal(request("catalan", "height", {suggested(message)}), {unlimited, long_law_seconds}),
            "");
  EXPECT_EQ(law_refusal(request("catalan", "strahler", {1e300}), {unlimited, long_law_seconds}), "");
}

TEST(LawRequest, OfVariancesOfCountsEndsBeforeTheirMeans) {
  const auto refused = [](double n, LawQuantity quantity) {
    return law_refusal(request("bst", "orders", {n}, quantity), {unlimited, unlimited});
  };
  EXPECT_EQ(refused(1e9, LawQuantity::moments), "");
  EXPECT_NE(refused(1e18, LawQuantity::moments), "");
  EXPECT_NE(refused(1e18, LawQuantity::covariances), "");
  EXPECT_EQ(refused(1e18, LawQuantity::law), "");
}

TEST(LawTable, SaysTheErrorOfWhatLiesBeyondTheExactLaws) {
  const auto rows =
      lines(write_csv(law_table(request("dst(0.3)", "strahler", {100, 5e5}, LawQuantity::moments), {})));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], "model,n,statistic,mean,variance,error,variance_error");
  EXPECT_TRUE(rows[1].ends_with(",,")) << rows[1];
  const double error = std::stod(rows[2].substr(rows[2].rfind(',', rows[2].rfind(',') - 1) + 1));
  EXPECT_GT(error, 0);
  EXPECT_LT(error, 1e-7);
}

TEST(LawTable, OfSizesWithinTheExactLawsHasNoErrors) {
  const auto rows = lines(write_csv(law_table(request("bst", "orders", {1000}), {})));
  EXPECT_EQ(rows[0], "model,n,leaf_order,order,mean_nodes,mean_streams");
}

TEST(LawTable, StopsWhenCancelled) {
  Cancellation cancellation;
  cancellation.request();
  for (const auto& statistic : law_subjects())
    EXPECT_THROW(law_table(request("bst", statistic, {5}), cancellation), Interrupted) << statistic;
}

}  // namespace
}  // namespace ramify
