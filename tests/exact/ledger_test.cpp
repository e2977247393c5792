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

/// What the committed table of a quick reproduction has, but for its columns on the samplers.
void expect_committed(const std::vector<Verdict>& verdicts) {
  const CsvData now = CsvData::parse(write_csv(verdict_table(verdicts)), "now");
  const CsvData committed =
      CsvData::read(std::string(RAMIFY_SOURCE_DIR) + "/results/reference/quick/verdicts.csv");
  ASSERT_EQ(now.rows(), committed.rows());
  for (std::size_t row = 0; row < now.rows(); ++row)
    for (const char* column :
         {"claim", "source", "statement", "convention", "relation", "formula", "theory", "rivals", "instead",
          "evidence", "standing", "estimate", "lower", "upper", "largest_n", "verdict", "method"})
      EXPECT_EQ(now.at(row, column), committed.at(row, column)) << now.at(row, "claim") << ' ' << column;
}

TEST(LedgerWithoutTrees, EveryPartIsJudgedByTheLawsAndItsRivalsAreRefused) {
  if (test::sanitized) GTEST_SKIP() << "laws to 10^100 take a minute";
  const auto judged = judged_without_trees();
  EXPECT_TRUE(judged.failures.empty()) << judged.failures.front();
  const std::set<std::string> refuted{"C4.2",  "C9.2",  "C11.5", "C11.6", "C12.1", "C12.3", "C12.4", "C19.1",
                                      "C20.2", "C20.3", "C21.1", "C21.2", "C23.4", "C23.9", "C24.3", "C33.6",
                                      "C35.2", "C35.3", "C35.4", "H2.1",  "H2.2",  "H2.4"};
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

}  // namespace
}  // namespace ramify
