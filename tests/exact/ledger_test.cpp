// All that the ledger says without a tree: every part is judged, on the exact laws, and its rivals are not
// believed.
#include "ledger.hpp"

#include <cmath>
#include <set>
#include <string>

#include "support/sanitized.hpp"
#include "verdicts.hpp"
#include <gtest/gtest.h>

#include "ramify/compare/judge.hpp"
#include "ramify/core/number.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {
namespace {

/// Judged once for all checks: ctest gives every test a process of its own.
Ledger::Judged judged_without_trees() {
  GrowthLimits limits;
  return Ledger().judged(claims(), limits, 2, {});
}

void expect_rivals_refused(const Verdict& verdict) {
  const auto& [statement, basis] = verdict.finding;
  for (std::size_t i = 0; i < statement.rivals.size(); ++i)
    EXPECT_NE(judge(with_rival(statement, i), basis.interval), Decision::reproduced)
        << statement.rivals[i].name;
  if (verdict.decision != Decision::refuted || !statement.instead) return;
  Statement truth = statement;
  truth.theory = statement.instead->value;
  truth.relation = Relation::equals;
  EXPECT_EQ(judge(truth, basis.interval), Decision::reproduced) << "what is said to hold instead";
}

/// The same words, or the same number but for its last digits, which exp and pow of the C library decide:
/// they differ between processors.
void expect_same(std::string_view now, std::string_view committed) {
  const auto number = parse_real(now), known = parse_real(committed);
  if (now == committed || !number || !known)
    EXPECT_EQ(now, committed);
  else
    EXPECT_NEAR(*number, *known, 1e-10 * std::abs(*known));
}

/// What the committed table of a quick reproduction has, but for its columns on the samplers.
void expect_committed(const std::vector<Verdict>& verdicts) {
  const CsvData now = CsvData::parse(write_csv(verdict_table(verdicts)), "now");
  const CsvData committed =
      CsvData::read(std::string(RAMIFY_SOURCE_DIR) + "/results/reference/quick/verdicts.csv");
  ASSERT_EQ(now.rows(), committed.rows());
  for (std::size_t row = 0; row < now.rows(); ++row)
    for (const char* column :
         {"claim", "source", "statement", "convention", "relation", "formula", "theory", "rivals", "instead",
          "evidence", "standing", "estimate", "lower", "upper", "largest_n", "verdict", "method"}) {
      SCOPED_TRACE(std::string(now.at(row, "claim")) + ' ' + column);
      expect_same(now.at(row, column), committed.at(row, column));
    }
}

TEST(LedgerWithoutTrees, EveryPartIsJudgedByTheLawsAndItsRivalsAreRefused) {
  if (test::sanitized) GTEST_SKIP() << "laws to 10^100 take a minute";
  const auto judged = judged_without_trees();
  EXPECT_TRUE(judged.failures.empty()) << judged.failures.front();
  const std::set<std::string> refuted{
      "C4.2",  "C9.2",   "C11.5",  "C11.6",  "C12.1", "C12.3", "C12.4", "C19.1", "C20.2", "C20.3",
      "C21.1", "C21.2",  "C23.4",  "C23.9",  "C24.3", "C33.6", "C35.2", "C35.3", "C35.4", "C35.6",
      "C35.9", "C35.10", "C35.11", "C35.12", "H2.1",  "H2.2",  "H2.4",  "H2.10", "H2.12", "H2.13"};
  std::size_t parts = 0;
  for (const Claim* claim : claims()) parts += claim->parts.size();
  EXPECT_EQ(judged.verdicts.size(), parts);
  for (const Verdict& verdict : judged.verdicts) {
    const std::string& part = verdict.finding.statement.part;
    SCOPED_TRACE(part);
    EXPECT_EQ(verdict.decision, refuted.contains(part) ? Decision::refuted : Decision::reproduced);
    EXPECT_EQ(verdict.sampler.word(), verdict.sampler.takes_trees ? "not sampled" : "-");
    expect_rivals_refused(verdict);
  }
  expect_committed(judged.verdicts);
}

std::size_t finite_points(const PlotSeries& series) {
  std::size_t finite = 0;
  for (const auto* points : {&series.points, &series.curve, &series.guide})
    for (const PlotPoint& point : *points) finite += std::isfinite(point.x) && std::isfinite(point.y) ? 1 : 0;
  return finite;
}

std::vector<NamedPlot> law_plots() {
  GrowthLimits limits;
  std::vector<NamedPlot> all;
  for (const Claim* claim : claims())
    if (claim->law_plots)
      for (auto& named : claim->law_plots({limits, {}})) {
        EXPECT_TRUE(named.stem.starts_with(std::string(claim->id) + "_")) << named.stem;
        all.push_back(std::move(named));
      }
  return all;
}

/// The last y of a series' points, or of its curve, at an x.
double last_of(const std::vector<NamedPlot>& plots, std::string_view stem, std::string_view label) {
  for (const auto& named : plots)
    if (named.stem == stem)
      for (const auto& series : named.plot.series)
        if (series.label.starts_with(label))
          return (series.points.empty() ? series.curve : series.points).back().y;
  ADD_FAILURE() << stem << ": no " << label;
  return 0;
}

TEST(LawPlots, ShowWhatTheirClaimsSay) {
  if (test::sanitized) GTEST_SKIP() << "laws to 10^12 take a minute";
  const auto plots = law_plots();
  std::set<std::string> stems;
  for (const auto& [stem, plot] : plots) {
    EXPECT_TRUE(stems.insert(stem).second) << stem;
    EXPECT_FALSE(plot.title.empty() || plot.y_label.empty()) << stem;
    EXPECT_GE(plot.series.size(), 2u) << stem;
    for (const auto& series : plot.series)
      EXPECT_GE(finite_points(series), 2u) << stem << ' ' << series.label;
  }
  EXPECT_EQ(stems, (std::set<std::string>{"C8_splits", "C9_ratios", "C10_split_order", "C11_split_ratios",
                                          "C12_node_ratios", "C14_balance_residual", "C15_fair_fill",
                                          "C16_trie_fill", "C22_order_fluctuation", "C23_stream_ratios",
                                          "C24_lung", "C24_ratio_map", "H2_recipe", "H2_ternary"}));
  EXPECT_NEAR(last_of(plots, "C9_ratios", "nodes of catalan"), 2, 1e-3);
  EXPECT_NEAR(last_of(plots, "C23_stream_ratios", "bst"), 3.0438, 1e-3);
  EXPECT_NEAR(last_of(plots, "C24_lung", "catalan"), 4, 1e-3);
  EXPECT_NEAR(last_of(plots, "C16_trie_fill", "p = 0.23"), 1 / std::log(1 / 0.23), 0.01);
  EXPECT_NEAR(last_of(plots, "C15_fair_fill", "claimed"), -1, 0.1);
  EXPECT_NEAR(last_of(plots, "H2_ternary", "maple_open"), 5, 1);
  EXPECT_NEAR(last_of(plots, "C24_ratio_map", "a = 20"), 2.9, 0.5);
}

}  // namespace
}  // namespace ramify
