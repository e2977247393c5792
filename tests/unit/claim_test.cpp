// The verdict rules on made-up cells: what they must reproduce, refute and leave open.
#include "claim.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "evidence.hpp"
#include "served_configs.hpp"
#include "support/columns.hpp"
#include "support/error_of.hpp"
#include "verdicts.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/config/run_config.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {
namespace {

/// Cells of a model in which the mean of one column is slope * log n + 0.2, with a small error.
ModelCells line_of(const std::string& model, const std::string& column, double slope,
                   double variance = 0.16) {
  ModelCells line{Model::parse(model), {}};
  for (double n = 300; n < 1e6; n *= 3.0438278618) {
    ColumnSummary summary{test::column(column)};
    summary.mean = slope * std::log(n) + 0.2;
    summary.variance = variance;
    summary.standard_error = 0.002;
    line.cells.push_back(
        {line.cells.size() + 1, {model, static_cast<Size>(n), 40000, {summary}, {}}, {std::nullopt}});
  }
  return line;
}

Outcome outcome_of(const std::vector<Verdict>& verdicts, const std::string& claim) {
  for (const auto& verdict : verdicts)
    if (verdict.claim == claim) return verdict.outcome;
  ADD_FAILURE() << claim << " was not judged";
  return Outcome::inconclusive;
}

TEST(BstOrderClaim, TellsTheTwoConstantsApart) {
  const Claim claim = bst_order_claim();
  const auto truth = claim.judge({line_of("bst", "strahler", 1 / std::log(3.0438278618))});
  EXPECT_EQ(outcome_of(truth, "C20.1"), Outcome::reproduced);
  EXPECT_EQ(outcome_of(truth, "C20.2"), Outcome::refuted);
  const auto thesis = claim.judge({line_of("bst", "strahler", 1 / std::log(3.0))});
  EXPECT_NE(outcome_of(thesis, "C20.2"), Outcome::refuted);
  const auto steeper = claim.judge({line_of("bst", "strahler", 1 / std::log(2.8))});
  EXPECT_EQ(outcome_of(steeper, "C20.1"), Outcome::refuted);
}

TEST(DepthClaim, RejectsTheDepthOfAnotherModel) {
  const Claim claim = depth_claim();
  EXPECT_EQ(outcome_of(claim.judge({line_of("bst", "depth", 2)}), "C6.1"), Outcome::reproduced);
  EXPECT_EQ(outcome_of(claim.judge({line_of("bst", "depth", 1.7142857)}), "C6.1"), Outcome::refuted)
      << "beta(2,2)";
}

TEST(HeightClaim, IsLeftOpenBySlopesThatFallShort) {
  EXPECT_EQ(outcome_of(height_claim().judge({line_of("bst", "height", 4.1)}), "C7.1"), Outcome::inconclusive);
}

TEST(CatalanClaim, SeesAGrowingVariance) {
  auto catalan = line_of("catalan", "strahler", 1 / std::log(4.0), 0.18);
  EXPECT_EQ(outcome_of(catalan_order_claim().judge({catalan}), "C22.2"), Outcome::reproduced);
  for (auto& cell : catalan.cells)
    cell.result.columns[0].variance = 0.05 * std::log(static_cast<double>(cell.result.n));
  EXPECT_EQ(outcome_of(catalan_order_claim().judge({catalan}), "C22.2"), Outcome::refuted);
}

TEST(CatalanClaim, WithoutAnySpreadIsLeftOpen) {
  auto catalan = line_of("catalan", "strahler", 1 / std::log(4.0), 0);
  for (auto& cell : catalan.cells) cell.result.replicates = 10;
  const auto verdicts = catalan_order_claim().judge({catalan});
  EXPECT_EQ(outcome_of(verdicts, "C22.2"), Outcome::inconclusive);
  for (const auto& verdict : verdicts) EXPECT_TRUE(std::isfinite(verdict.upper)) << verdict.claim;
}

TEST(Claims, AreFoundByNumberAndRefusedOtherwise) {
  EXPECT_EQ(find_claims("C6 C7").size(), 2u);
  EXPECT_TRUE(find_claims("").empty());
  EXPECT_THROW(find_claims("C6 C99"), Error);
}

TEST(Claims, EveryOneHasAConfigWithWhatItNeedsAtBothScales) {
  for (const char* scale : {"quick", "full"}) {
    std::set<std::string_view> served;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(RAMIFY_SOURCE_DIR) + "/configs/" + scale))
      for (const Claim* claim : served_claims(read_run_config(entry.path()))) served.insert(claim->id);
    for (const auto& claim : claims()) EXPECT_TRUE(served.contains(claim.id)) << claim.id << ' ' << scale;
  }
}

TEST(PatriciaClaims, NumberTheModelsOfTheConfigsInTheirOrder) {
  const auto verdicts = patricia_order_claim().judge(
      {line_of("patricia(1/2.74)", "strahler", 0.99), line_of("patricia(0.4)", "strahler", 1.09)});
  ASSERT_EQ(verdicts.size(), 2u);
  EXPECT_EQ(verdicts[0].claim, "C13.1");
  EXPECT_EQ(verdicts[0].statement, "S_n ~ log(n)/log(1/p), patricia(1/2.74)");
  EXPECT_EQ(verdicts[1].claim, "C13.2");
  EXPECT_NEAR(verdicts[1].theory, 1 / std::log(2.5), 1e-12);
  EXPECT_EQ(verdicts[1].outcome, Outcome::reproduced);
}

/// A config with the needs of its claim but for what is put in their place.
RunConfig config_of(const std::string& claim, const std::string& model, const std::string& statistic,
                    int sizes = 4, int trees = 10) {
  return parse_run_config(fmt::format("claim = \"{}\"\nmodels = [\"{}\"]\nstatistics = [\"{}\"]\n"
                                      "n = {{ from = 10, factor = 2, count = {} }}\nreplicates = {}\n",
                                      claim, model, statistic, sizes, trees),
                          "c.toml");
}

std::string config_refusal(const RunConfig& config) {
  return test::error_of([&] { served_claims(config); });
}

TEST(ServedClaims, AreThoseOfWhichNothingIsMissing) {
  EXPECT_EQ(config_refusal(config_of("C20", "bst", "strahler")), "");
  EXPECT_EQ(config_refusal(config_of("C20", "bst", "height")),
            "c.toml: claim C20 without 'strahler' (it is judged by that statistic): add it to statistics");
  EXPECT_EQ(config_refusal(config_of("C20", "catalan", "strahler")),
            "c.toml: claim C20 with model catalan (it speaks of random binary search trees, bst): take the "
            "model, or the claim, out of the config");
  EXPECT_EQ(config_refusal(config_of("C22", "catalan", "strahler", 3)),
            "c.toml: claim C22 with 3 sizes of catalan (it is judged over 4 or more): add sizes to n");
  EXPECT_EQ(
      config_refusal(config_of("C22", "catalan", "strahler", 4, 9)),
      "c.toml: claim C22 with 9 replicate(s) at n = 10 (the error of a mean is taken from the spread of its "
      "trees): take 10 or more");
  EXPECT_EQ(config_refusal(config_of("C6", "catalan", "depth")).substr(0, 33),
            "c.toml: claim C6 with model catal");
  EXPECT_EQ(config_refusal(config_of("C7", "trie(0.3)", "height")).substr(0, 27),
            "c.toml: claim C7 with model");
}

/// The cells of a config as a run would have them.
std::vector<CheckedCell> cells_of(const RunConfig& config) {
  std::vector<CheckedCell> cells;
  for (const auto& group : config.groups)
    for (const auto& model : group.models)
      for (const Size n : group.sizes) {
        ColumnSummary summary{*config.statistics.chosen().front()};
        summary.mean = 2 * std::log(static_cast<double>(n));
        summary.standard_error = 0.01;
        cells.push_back({cells.size() + 1, {model.text(), n, 100, {summary}, {}}, {std::nullopt}});
      }
  return cells;
}

TEST(Evidence, OfTwoConfigsIsThatOfOne) {
  const RunConfig small = config_of("C6", "bst", "depth"), large = config_of("C6", "beta(1,1)", "depth", 8);
  Evidence evidence;
  evidence.add(large, {cells_of(large)});
  evidence.add(small, {cells_of(small)});
  EXPECT_EQ(evidence.verdicts().size(), 2u);
  EXPECT_EQ(evidence.verdicts().front().statement, "E D_n ~ log(n)/mu, beta(1,1)");
}

const std::filesystem::path reference = std::filesystem::path(RAMIFY_SOURCE_DIR) / "results/reference/quick";

/// The cells of a committed table, to the ten digits that it prints.
std::vector<CheckedCell> committed_cells(const RunConfig& config) {
  const CsvData table =
      CsvData::read(reference / std::filesystem::path(config.path).stem().replace_extension(".csv"));
  std::vector<CheckedCell> cells;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (cells.size() < table.count(row, "cell"))
      cells.push_back({table.count(row, "cell"),
                       {std::string(table.at(row, "model")),
                        table.count(row, "n"),
                        table.count(row, "replicates"),
                        {},
                        {}},
                       {}});
    ColumnSummary column{test::column(table.at(row, "statistic"))};
    column.mean = table.real(row, "mean");
    column.standard_error = table.real(row, "standard_error");
    column.variance = table.real(row, "variance");
    cells.back().result.columns.push_back(column);
    std::optional<ExactCheck> check;
    if (!table.at(row, "z").empty()) check = {table.real(row, "exact_mean"), table.real(row, "z")};
    cells.back().checks.push_back(check);
  }
  return cells;
}

/// The method of a verdict without the checks against exact means, whose one digit more digits decide.
std::string_view without_checks(std::string_view method) {
  return method.substr(0, method.find("; sampled means"));
}

TEST(Verdicts, OfTheCommittedCellsAreTheCommittedOnes) {
  Evidence evidence;
  for (const auto& file : config_files(std::string(RAMIFY_SOURCE_DIR) + "/configs/quick")) {
    const RunConfig config = read_run_config(file);
    if (config.claim) evidence.add(config, {committed_cells(config)});
  }
  const CsvData now = CsvData::parse(write_csv(verdict_table(evidence.verdicts())), "now");
  const CsvData committed = CsvData::read(reference / "verdicts.csv");
  ASSERT_EQ(now.rows(), committed.rows());
  for (std::size_t row = 0; row < now.rows(); ++row) {
    SCOPED_TRACE(committed.at(row, "claim"));
    for (const char* column :
         {"claim", "source", "statement", "convention", "theory", "largest_n", "verdict"})
      EXPECT_EQ(now.at(row, column), committed.at(row, column));
    EXPECT_EQ(without_checks(now.at(row, "method")), without_checks(committed.at(row, "method")));
    for (const char* column : {"estimate", "standard_error", "lower", "upper"})
      EXPECT_NEAR(now.real(row, column), committed.real(row, column), 1e-7) << column;
  }
}

TEST(Verdicts, AChangeAgainstTheCommittedTableIsSeen) {
  auto verdicts = bst_order_claim().judge({line_of("bst", "strahler", 1 / std::log(3.0438278618))});
  const auto file = std::filesystem::temp_directory_path() / "ramify_verdicts_test.csv";
  std::ofstream(file) << write_csv(verdict_table(verdicts));
  EXPECT_TRUE(changed_verdicts(verdicts, file, Compared::all).empty());
  verdicts.front().outcome = Outcome::inconclusive;
  EXPECT_EQ(changed_verdicts(verdicts, file, Compared::all),
            std::vector<std::string>{"C20.1: inconclusive, was reproduced"});
  std::filesystem::remove(file);
}

TEST(Verdicts, OneThatIsMissingOrNewIsSeenUnlessTheRunWasNarrowed) {
  auto verdicts = bst_order_claim().judge({line_of("bst", "strahler", 1 / std::log(3.0438278618))});
  const auto file = std::filesystem::temp_directory_path() / "ramify_missing_verdicts_test.csv";
  std::ofstream(file) << write_csv(verdict_table(verdicts));
  verdicts.front().claim = "C20.4";
  EXPECT_EQ(changed_verdicts(verdicts, file, Compared::all),
            (std::vector<std::string>{
                "C20.1: no verdict on 'P{S_n >= (1+eps) log_3 n} -> 0, bst', was reproduced",
                "C20.4: reproduced on 'P{S_n >= (1+eps) log_3 n} -> 0, bst', was not there"}));
  EXPECT_TRUE(changed_verdicts(verdicts, file, Compared::those_in_both).empty());
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace ramify
