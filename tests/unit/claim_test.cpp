// The verdict rules on made-up cells: what they must reproduce, refute and leave open.
#include "claim.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "verdicts.hpp"
#include <gtest/gtest.h>

#include "ramify/config/run_config.hpp"
#include "ramify/core/error.hpp"
#include "ramify/io/csv_writer.hpp"

namespace ramify {
namespace {

/// Cells of a model in which the mean of one column is slope * log n + 0.2, with a small error.
std::vector<CheckedCell> line_of(const std::string& model, const std::string& column, double slope,
                                 double variance = 0.16) {
  std::vector<CheckedCell> cells;
  std::size_t number = 0;
  for (double n = 300; n < 1e6; n *= 3.0438278618) {
    ColumnSummary summary;
    summary.name = column;
    summary.mean = slope * std::log(n) + 0.2;
    summary.variance = variance;
    summary.standard_error = 0.002;
    cells.push_back({++number, {model, static_cast<Size>(n), 40000, {summary}, {}}, {std::nullopt}});
  }
  return cells;
}

Outcome outcome_of(const std::vector<Verdict>& verdicts, const std::string& claim) {
  for (const auto& verdict : verdicts)
    if (verdict.claim == claim) return verdict.outcome;
  ADD_FAILURE() << claim << " was not judged";
  return Outcome::inconclusive;
}

TEST(BstOrderClaim, TellsTheTwoConstantsApart) {
  const Claim claim = bst_order_claim();
  const auto truth = claim.judge(line_of("bst", "strahler", 1 / std::log(3.0438278618)));
  EXPECT_EQ(outcome_of(truth, "C20.1"), Outcome::reproduced);
  EXPECT_EQ(outcome_of(truth, "C20.2"), Outcome::refuted);
  const auto thesis = claim.judge(line_of("bst", "strahler", 1 / std::log(3.0)));
  EXPECT_NE(outcome_of(thesis, "C20.2"), Outcome::refuted);
  const auto steeper = claim.judge(line_of("bst", "strahler", 1 / std::log(2.8)));
  EXPECT_EQ(outcome_of(steeper, "C20.1"), Outcome::refuted);
}

TEST(DepthClaim, RejectsTheDepthOfAnotherModel) {
  const Claim claim = depth_claim();
  EXPECT_EQ(outcome_of(claim.judge(line_of("bst", "depth", 2)), "C6.1"), Outcome::reproduced);
  EXPECT_EQ(outcome_of(claim.judge(line_of("bst", "depth", 1.7142857)), "C6.1"), Outcome::refuted)
      << "beta(2,2)";
}

TEST(HeightClaim, IsLeftOpenBySlopesThatFallShort) {
  EXPECT_EQ(outcome_of(height_claim().judge(line_of("bst", "height", 4.1)), "C7.1"), Outcome::inconclusive);
}

TEST(CatalanClaim, SeesAGrowingVariance) {
  auto cells = line_of("catalan", "strahler", 1 / std::log(4.0), 0.18);
  EXPECT_EQ(outcome_of(catalan_order_claim().judge(cells), "C22.2"), Outcome::reproduced);
  for (auto& cell : cells)
    cell.result.columns[0].variance = 0.05 * std::log(static_cast<double>(cell.result.n));
  EXPECT_EQ(outcome_of(catalan_order_claim().judge(cells), "C22.2"), Outcome::refuted);
}

TEST(Claims, AreFoundByNumberAndRefusedOtherwise) {
  EXPECT_EQ(find_claims("C6 C7").size(), 2u);
  EXPECT_TRUE(find_claims("").empty());
  EXPECT_THROW(find_claims("C6 C99"), Error);
}

TEST(Claims, EveryOneHasAConfigAtBothScales) {
  for (const char* scale : {"quick", "full"}) {
    std::string served;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(RAMIFY_SOURCE_DIR) + "/configs/" + scale))
      served.append(1, ' ').append(read_run_config(entry.path()).claim.value_or(""));
    const auto found = find_claims(served);
    for (const auto& claim : claims())
      EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Claim* c) { return c->id == claim.id; }))
          << claim.id << " at scale " << scale;
  }
}

TEST(Verdicts, AChangeAgainstTheCommittedTableIsSeen) {
  auto verdicts = bst_order_claim().judge(line_of("bst", "strahler", 1 / std::log(3.0438278618)));
  const auto file = std::filesystem::temp_directory_path() / "ramify_verdicts_test.csv";
  std::ofstream(file) << write_csv(verdict_table(verdicts));
  EXPECT_TRUE(changed_verdicts(verdicts, file).empty());
  verdicts.front().outcome = Outcome::inconclusive;
  EXPECT_EQ(changed_verdicts(verdicts, file),
            std::vector<std::string>{"C20.1: inconclusive, was reproduced"});
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace ramify
