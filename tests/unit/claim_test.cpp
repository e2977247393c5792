// Claims and their ledger, on made-up cells: what configs must bring, which parts are judged, how samplers
// are held against laws, which changes of verdicts are seen.
#include "claim.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "ledger.hpp"
#include "lung.hpp"
#include "measured_lung.hpp"
#include "served_configs.hpp"
#include "support/columns.hpp"
#include "support/error_of.hpp"
#include "support/scratch.hpp"
#include "verdicts.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/config/run_config.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {
namespace {

TEST(Claims, AreFoundByNumberAndRefusedOtherwise) {
  EXPECT_EQ(find_claims("C6 C7").size(), 2u);
  EXPECT_TRUE(find_claims("").empty());
  EXPECT_THROW(find_claims("C6 C99"), Error);
  EXPECT_EQ(find_claims("c20"), find_claims("C20"));
  EXPECT_EQ(find_claims("c20.2"), find_claims("C20"));
  EXPECT_EQ(test::error_of([] { find_claims("C20.4"); }),
            "claim C20.4 (the parts of C20 end with C20.3): see: ramify list claims");
}

TEST(Claims, EveryOneThatTakesTreesHasAConfigWithWhatItNeedsAtBothScales) {
  for (const char* scale : {"quick", "full"}) {
    std::set<std::string_view> served;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(RAMIFY_SOURCE_DIR) + "/configs/" + scale))
      for (const Claim* claim : served_claims(read_run_config(entry.path()))) served.insert(claim->id);
    for (const Claim* claim : claims())
      EXPECT_EQ(served.contains(claim->id), claim->takes_trees()) << claim->id << ' ' << scale;
  }
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
            "c.toml: claim C20 without 'strahler' (it is of that statistic): add it to statistics");
  EXPECT_EQ(config_refusal(config_of("C20", "catalan", "strahler")),
            "c.toml: claim C20 with model catalan (its parts are of bst): take the "
            "model, or the claim, out of the config");
  EXPECT_EQ(
      config_refusal(config_of("C22", "catalan", "strahler", 3)),
      "c.toml: claim C22 with 3 sizes of catalan (4 or more are held against the laws): add sizes to n");
  EXPECT_EQ(
      config_refusal(config_of("C22", "catalan", "strahler", 4, 9)),
      "c.toml: claim C22 with 9 replicate(s) at n = 10 (the error of a mean is taken from the spread of its "
      "trees): take 10 or more");
  EXPECT_EQ(config_refusal(config_of("C6", "catalan", "depth")).substr(0, 33),
            "c.toml: claim C6 with model catal");
  EXPECT_EQ(config_refusal(config_of("C7", "trie(0.3)", "height")).substr(0, 27),
            "c.toml: claim C7 with model");
}

/// The cells of a config as a run would have them, all as many standard errors off.
std::vector<CheckedCell> cells_of(const RunConfig& config, double z) {
  std::vector<CheckedCell> cells;
  for (const auto& group : config.groups)
    for (const auto& model : group.models)
      for (const Size n : group.sizes) {
        ColumnSummary summary{*config.statistics.chosen().front()};
        summary.mean = 2 * std::log(static_cast<double>(n));
        summary.standard_error = 0.01;
        cells.push_back(
            {cells.size() + 1, {model.text(), n, 100, {summary}, {}}, {ExactCheck{summary.mean, z}}});
      }
  return cells;
}

TEST(Ledger, OfTwoConfigsHasTheCellsOfBoth) {
  const RunConfig small = config_of("C6", "bst", "depth"), large = config_of("C6", "beta(10,10)", "depth", 8);
  Ledger ledger;
  ledger.add(large, {cells_of(large, 0.5)});
  ledger.add(small, {cells_of(small, -1.5)});
  ASSERT_EQ(ledger.served().size(), 1u);
  EXPECT_EQ(ledger.served().front()->id, "C6");
  EXPECT_EQ(ledger.worst_check().check.means, 12u);
  EXPECT_EQ(ledger.worst_check().check.worst_z, 1.5);
}

/// A claim of one part, with a basis of one's own.
Claim claim_of(std::function<Basis(const Evidence&)> basis) {
  Statement statement{"C6.1", "E D_n ~ 2 log n", "nobody",    "nodes", Relation::equals, "2",
                      2,      {{"1", 1}},        std::nullopt};
  return {
      "C6", "a claim", "nobody", {{statement, Model::parse("bst"), &statistic::depth, std::move(basis)}}, {}};
}

Basis found(double lower, double estimate, double upper) {
  return {EvidenceKind::limit, Standing::extrapolated, estimate, {lower, upper}, 1e9, "made up", "nothing"};
}

Ledger::Judged judged(const Ledger& ledger, const Claim& claim) {
  GrowthLimits limits;
  return ledger.judged({&claim}, limits, 1, {});
}

TEST(Ledger, JudgesAPartByItsBasisAndTheSamplerByItsCells) {
  const RunConfig config = config_of("C6", "bst", "depth");
  Ledger ledger;
  ledger.add(config, {cells_of(config, -3)});
  const auto all = judged(ledger, claim_of([](const Evidence&) { return found(1.9, 2, 2.1); }));
  ASSERT_EQ(all.verdicts.size(), 1u);
  EXPECT_EQ(all.verdicts.front().decision, Decision::reproduced);
  EXPECT_EQ(all.verdicts.front().sampler.means, 4u);
  EXPECT_EQ(all.verdicts.front().sampler.worst_z, 3);
  EXPECT_EQ(all.verdicts.front().sampler.word(), "ok");
}

TEST(Ledger, APartWithoutTreesChecksNoSampler) {
  Claim claim = claim_of({});
  EXPECT_TRUE(claim.takes_trees());
  claim.parts = {
      part_without_trees(claim.parts.front().statement, [](const Evidence&) { return found(1.9, 2, 2.1); })};
  EXPECT_FALSE(claim.takes_trees());
  EXPECT_FALSE(claim.speaks_of(Model::parse("bst")));
  const auto all = judged(Ledger(), claim);
  ASSERT_EQ(all.verdicts.size(), 1u);
  EXPECT_EQ(all.verdicts.front().sampler.word(), "-");
  EXPECT_EQ(all.verdicts.front().decision, Decision::reproduced);
}

TEST(Ledger, ASamplerBesideItsLawFailsWhateverTheClaim) {
  const RunConfig config = config_of("C6", "bst", "depth");
  Ledger ledger;
  ledger.add(config, {cells_of(config, 5.2)});
  EXPECT_TRUE(ledger.worst_check().check.failed()) << "of four means none may lie 5.03 off";
  const auto all = judged(ledger, claim_of([](const Evidence&) { return found(1.9, 2, 2.1); }));
  EXPECT_EQ(all.verdicts.front().sampler.word(), "failed");
  EXPECT_EQ(all.verdicts.front().decision, Decision::reproduced);
}

TEST(Ledger, APartThatCannotBeJudgedIsNamed) {
  const auto thrown =
      judged(Ledger(), claim_of([](const Evidence&) -> Basis { throw Error("no law", "why", "go"); }));
  EXPECT_TRUE(thrown.verdicts.empty());
  EXPECT_EQ(thrown.failures, std::vector<std::string>{"C6.1 cannot be judged: no law (why): go"});
  const auto no_number =
      judged(Ledger(), claim_of([](const Evidence&) { return found(1, std::nan(""), 2); }));
  ASSERT_EQ(no_number.failures.size(), 1u);
  EXPECT_EQ(no_number.failures.front().substr(0, 22), "C6.1 cannot be judged:");
}

TEST(Claims, DeclareTheirPartsWithRivalsThatAreNotTheirTheory) {
  std::set<std::string> names;
  for (const Claim* claim : claims()) {
    EXPECT_FALSE(claim->parts.empty()) << claim->id;
    EXPECT_EQ(find_claims(claim->id), std::vector{claim});
    for (const auto& part : claim->parts) {
      const Statement& statement = part.statement;
      EXPECT_TRUE(statement.part.starts_with(std::string(claim->id) + ".")) << statement.part;
      EXPECT_TRUE(names.insert(statement.part).second) << statement.part;
      for (const auto& rival : statement.rivals) EXPECT_NE(rival.value, statement.theory) << statement.part;
    }
  }
  const CsvData listed = CsvData::parse(write_csv(claim_table()), "list claims");
  EXPECT_EQ(listed.rows(), names.size());
}

TEST(Claims, HaveTheLungAsItsTablePrintsIt) {
  const CsvData lung = CsvData::read(std::string(RAMIFY_SOURCE_DIR) + "/data/lung.csv");
  ASSERT_EQ(lung.rows(), 2u);
  for (std::size_t row = 0; row < lung.rows(); ++row) {
    const LungTree& tree = lung.text(row, "name") == "bronchial tree" ? bronchial_tree : pulmonary_artery;
    EXPECT_EQ(lung.real(row, "ratio"), tree.bifurcation.value);
    EXPECT_EQ(lung.real(row, "diameter_ratio"), tree.diameter.value);
    EXPECT_EQ(lung.count(row, "max_order_high"), lung_orders);
    EXPECT_NEAR(lung.real(row, "root_diameter_mm"), 10 * tree.largest_cm.value, 1e-12);
  }
}

void expect_table(std::span<const VesselOrder> vessels, const char* file) {
  const CsvData table = CsvData::read(fmt::format("{}/data/{}.csv", RAMIFY_SOURCE_DIR, file));
  ASSERT_EQ(table.rows(), vessels.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    EXPECT_EQ(table.real(row, "order"), vessels[row].order) << file;
    EXPECT_EQ(table.real(row, "count"), vessels[row].count) << file;
    EXPECT_EQ(table.real(row, "length"), vessels[row].length) << file;
    if (table.at(row, "diameter").empty())
      EXPECT_TRUE(std::isnan(vessels[row].diameter)) << file;
    else
      EXPECT_EQ(table.real(row, "diameter"), vessels[row].diameter) << file;
  }
}

TEST(MeasuredLung, IsTheTablesOfTheData) {
  expect_table(measured_artery, "pulmonary_artery");
  expect_table(measured_vein, "pulmonary_vein");
}

// By hand: 1, 2, 4, 8 at 0..3 have the slope 2.3 and the residuals 0.7, -0.6, -0.9, 0.8; the parabola is
// 2x^2 - x + 5.
TEST(LeadingCoefficient, IsThatOfLeastSquares) {
  const std::vector<double> x{0, 1, 2, 3}, y{1, 2, 4, 8}, parabola{5, 6, 11, 20};
  const FittedCoefficient line = leading_coefficient(x, y, 1);
  EXPECT_NEAR(line.value, 2.3, 1e-14);
  EXPECT_NEAR(line.standard_error, std::sqrt(2.3 / 2 / 5), 1e-14);
  EXPECT_EQ(line.degrees, 2);
  const FittedCoefficient curved = leading_coefficient(x, parabola, 2);
  EXPECT_NEAR(curved.value, 2, 1e-13);
  EXPECT_NEAR(curved.standard_error, 0, 1e-13);
  const Interval interval = line.interval(0.05);  // t = 4.302652730 of two degrees
  EXPECT_NEAR(interval.upper - line.value, 4.302652730 * line.standard_error, 1e-8);
}

/// Three verdicts, the second refuted.
std::vector<Verdict> some_verdicts() {
  std::vector<Verdict> verdicts;
  for (const char* part : {"C20.1", "C20.2", "C20.3"}) {
    Statement statement{part, "a sentence", "nobody", "none", Relation::equals, "2", 2, {}, std::nullopt};
    verdicts.push_back({{statement, found(1.9, 2, 2.1)}, Decision::reproduced, {}});
  }
  verdicts[1].decision = Decision::refuted;
  return verdicts;
}

/// A committed table of them.
struct CommittedVerdicts {
  const test::Scratch scratch;
  const std::filesystem::path file = scratch.file("verdicts.csv", write_csv(verdict_table(some_verdicts())));
};

TEST(Verdicts, AChangeAgainstTheCommittedTableIsSeen) {
  const CommittedVerdicts committed;
  auto verdicts = some_verdicts();
  EXPECT_TRUE(changed_verdicts(verdicts, committed.file, {}).empty());
  verdicts.front().decision = Decision::inconclusive;
  EXPECT_EQ(changed_verdicts(verdicts, committed.file, {}),
            std::vector<std::string>{"C20.1: inconclusive, was reproduced"});
}

TEST(Verdicts, OneThatIsMissingOrNewIsSeenUnlessTheRunWasNarrowedToOtherClaims) {
  const CommittedVerdicts committed;
  auto verdicts = some_verdicts();
  verdicts.front().finding.statement.part = "C20.4";
  EXPECT_EQ(changed_verdicts(verdicts, committed.file, {}),
            (std::vector<std::string>{"C20.1: no verdict on 'a sentence', was reproduced",
                                      "C20.4: reproduced on 'a sentence', was not there"}));
  EXPECT_EQ(changed_verdicts(verdicts, committed.file, {"C3", "C20"}).size(), 2u);
  EXPECT_TRUE(changed_verdicts({}, committed.file, {"C3", "C2"}).empty());
}

TEST(Verdicts, AnOpenOneSaysWhatWouldDecideIt) {
  auto verdicts = some_verdicts();
  verdicts.front().decision = Decision::inconclusive;
  EXPECT_EQ(std::get<std::string>(verdict_table(verdicts).at(0, "method")),
            "made up; what would decide it: nothing");
}

}  // namespace
}  // namespace ramify
