// The page of the ledger: words made of verdicts, a section a claim, the same page for the same verdicts.
#include "ledger_page.hpp"

#include <string>
#include <vector>

#include "verdict_words.hpp"
#include <gtest/gtest.h>

#include "ramify/compare/judge.hpp"
#include "ramify/io/csv_writer.hpp"
#include "ramify/page/html_writer.hpp"
#include "ramify/page/markdown_writer.hpp"

namespace ramify {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Of a statement about 2, with the rivals 1 and 2.5.
Verdict verdict_in(const Interval& interval, Relation relation = Relation::equals) {
  Statement statement{"C20.1",
                      "a sentence",
                      "K96 9.9",
                      "leaf order 0",
                      relation,
                      "1 + 1",
                      2,
                      {{"one", 1}, {"two and a half", 2.5}},
                      NamedValue{"what holds", 3}};
  Basis basis{
      EvidenceKind::limit, Standing::extrapolated, (interval.lower + interval.upper) / 2, interval, 1e9,
      "made up",           "larger trees"};
  return {{statement, basis}, judge(statement, interval), {4, 1.26, 5.03}};
}

TEST(VerdictWords, AreThreeSentencesOfWhatTheLedgerKnows) {
  EXPECT_EQ(
      how_reached(verdict_in({1.9, 2.1})),
      "The number lies in [1.9000, 2.1000]; that rests on exact laws at growing n, and the numbers are "
      "taken to go on as they did. It contains the theory, 1 + 1 (2), and excludes every rival: "
      "reproduced. Apart from that the sampler was held against the exact law: of 4 means the worst lies "
      "1.3 standard errors off, where 5.0 are allowed.");
  EXPECT_TRUE(holds(how_reached(verdict_in({2.75, 3.25})),
                    "The theory, 1 + 1 (2), lies 1.5 of its widths below it: refuted."));
  EXPECT_TRUE(
      holds(how_reached(verdict_in({1.9, 2.6})),
            "It holds rivals too: two and a half, so the verdict is inconclusive; what would decide it: "
            "larger trees."));
}

TEST(VerdictWords, OfBoundsSayWhetherAllOfTheIntervalKeepsThem) {
  EXPECT_TRUE(holds(how_reached(verdict_in({1.5, 1.75}, Relation::at_most)),
                    "All of it keeps the bound, at most 1 + 1 (2), and excludes every rival: reproduced."));
  EXPECT_TRUE(holds(how_reached(verdict_in({2.125, 2.25}, Relation::at_most)),
                    "All of it breaks the bound, at most 1 + 1 (2): refuted."));
  EXPECT_TRUE(holds(how_reached(verdict_in({1.9, 2.2}, Relation::at_most)),
                    "It lies on both sides of the bound, so the verdict is inconclusive"));
}

TEST(VerdictWords, SayWhichSamplersWereNotCheckedAndWhichFailed) {
  Verdict verdict = verdict_in({1.9, 2.1});
  verdict.sampler = {0, 0, 0, false};
  EXPECT_TRUE(holds(how_reached(verdict), "there is no sampler to hold against a law"));
  verdict.sampler = {0, 0, 0, true};
  EXPECT_TRUE(holds(how_reached(verdict), "No config of this run samples its trees"));
  verdict.sampler = {4, 6, 5, true};
  EXPECT_TRUE(holds(how_reached(verdict), "FAILED"));
}

// Every value is judged by the rule that judged the theory.
TEST(VerdictWords, ControlsAreRivalsAndWhatHoldsInTheTheorysPlace) {
  EXPECT_EQ(write_csv(control_table({verdict_in({2.75, 3.25})})),
            "part,in the theory's place,which is,value,outside by,in widths,verdict then,power\n"
            "C20.1,one,rival,1,1.75,3.5,refuted,1\n"
            "C20.1,two and a half,rival,2.5,0.25,0.5,refuted,1\n"
            "C20.1,what holds,holds instead,3,0,0,reproduced,0\n");
}

Reproduction one_claim() {
  Reproduction reproduction{"quick", "c20", " --seed 7", {}, find_claims("C20 C3"), {}};
  reproduction.judged.verdicts = {verdict_in({1.9, 2.1})};
  reproduction.judged.failures = {"C3.1 cannot be judged: no law"};
  return reproduction;
}

std::vector<FiledPlot> two_plots() {
  PlotFiles missing;
  missing.status = PlotStatus::no_gnuplot;
  Plot plot{"A plot", "of points", "n", "mean", true};
  plot.series.push_back({"bst", {{10, 1.5, 0.25}, {100, 3}}});
  return {{{"C20_order", plot}, missing}, {{"C2_order", plot}, missing}};
}

TEST(LedgerPage, HasASectionForEveryClaimWithItsVerdictsPlotsAndCommand) {
  const Reproduction reproduction = one_claim();
  const auto claims = claims_on_page(reproduction, two_plots());
  ASSERT_EQ(claims.size(), 2u);
  EXPECT_EQ(claims[0].verdicts.size(), 1u);
  EXPECT_EQ(claims[0].plots.size(), 1u) << "the other is of C2";
  EXPECT_TRUE(claims[1].verdicts.empty());
  const std::string page = write_markdown(ledger_page(reproduction, claims));
  for (const char* part :
       {"finds of 1 statement in 2 claims, at the quick scale: 1 reproduced, 0 refuted, 0 inconclusive",
        "- C3.1 cannot be judged: no law\n", "\n## C20: S_n", "\n### C20.1: a sentence: reproduced\n",
        "- Claimed in K96 9.9.\n", "- Convention: leaf order 0.\n", "- Method: made up.\n",
        "- What holds instead: what holds (3).\n", "Picture missing (A plot): gnuplot is not installed.",
        "    ramify reproduce --scale quick --claim C20 --seed 7\n", "claims/C20_points.csv",
        "    ramify reproduce --scale quick --claim c20 --seed 7\n", "No trees were sampled",
        "\n## C3: the chain has order 1, the complete tree of k levels k-1\n\nSource: K96 3.1.1.\n\nNone of "
        "its parts "
        "could be judged.\n"})
    EXPECT_TRUE(holds(page, part)) << part << '\n' << page;
}

// Every claim leads to a tree of each model that its parts take trees of; a model of two claims is drawn
// once.
TEST(LedgerPage, LeadsToATreeOfEveryModel) {
  Reproduction reproduction = one_claim();
  reproduction.claims = find_claims("C20 C19 C22");
  reproduction.trees = sample_trees(reproduction.claims, 7, {});
  ASSERT_EQ(reproduction.trees.size(), 2u);
  EXPECT_EQ(reproduction.trees[0].command(),
            "ramify draw --model bst --n 100 --seed 7 --style branches -o tree.svg");
  const auto claims = claims_on_page(reproduction, {});
  for (const ClaimOnPage& of : claims) EXPECT_EQ(of.trees.size(), 1u) << of.claim.id;
  const std::string html = write_html(ledger_page(reproduction, claims));
  for (const char* model : {"bst", "catalan"}) {
    const std::string anchor = std::string("tree-") + model;
    EXPECT_TRUE(holds(html, "<a href=\"#" + anchor + "\">" + model + "</a>")) << model;
    EXPECT_TRUE(holds(html, "id=\"" + anchor + "\"")) << model;
    EXPECT_TRUE(holds(html, std::string(model) + ", n = 100, seed 7, replicate 0")) << model;
  }
}

TEST(SampleTree, HasAnAnchorOfWords) {
  const SampleTree tree{Model::parse("patricia(1/2.74)"), 100, 1, {}};
  EXPECT_EQ(tree.anchor(), "tree-patricia-1-2-74");
  EXPECT_EQ(tree.command(),
            "ramify draw --model 'patricia(1/2.74)' --n 100 --seed 1 --style branches -o tree.svg");
}

TEST(LedgerPage, LeadsFromEveryRowToItsPart) {
  const Reproduction reproduction = one_claim();
  const std::string html = write_html(ledger_page(reproduction, claims_on_page(reproduction, {})));
  EXPECT_TRUE(holds(html, "<a href=\"#C20.1\">C20.1</a>"));
  EXPECT_TRUE(holds(html, "<h3 id=\"C20.1\">"));
  EXPECT_TRUE(holds(html, "<span class=\"badge good\">reproduced</span>"));
  EXPECT_TRUE(holds(html, "<legend>verdict</legend>") && holds(html, "<legend>evidence</legend>"));
  EXPECT_EQ(html, write_html(ledger_page(reproduction, claims_on_page(reproduction, {}))));
}

TEST(FiledPlots, AreATableOfTheirPoints) {
  EXPECT_EQ(write_csv(points_table({two_plots().front()})),
            "picture,series,kind,x,y,error\nC20_order,bst,point,10,1.5,0.25\nC20_order,bst,point,100,3,\n");
  EXPECT_EQ(why_missing(two_plots()), "gnuplot is not installed");
  PlotFiles nothing;
  nothing.status = PlotStatus::no_points;
  EXPECT_EQ(why_missing({{{"C2_order", {}}, nothing}}), "") << "nothing to draw is nothing missed";
}

}  // namespace
}  // namespace ramify
