// The words of a report, from numbers that are given.
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "ramify/dossier/commands.hpp"
#include "ramify/dossier/plain_words.hpp"
#include "ramify/page/shell_word.hpp"
#include "ramify/statistic/registry.hpp"

namespace ramify {
namespace {

/// Log-likelihoods are chosen so that AIC is what is given.
FamilyFit fit_with(const char* family, double aic) {
  FamilyFit fit = without_fit(find_family(family), 100);
  fit.converged = true;
  for (const FamilyParameter& parameter : fit.family->parameters)
    fit.parameters.push_back({parameter.name, 0.25, 0.01, 0.23, 0.27, false, false});
  fit.log_likelihood = static_cast<double>(fit.parameters.size()) - aic / 2;
  fit.goodness = {1, 0.4, 0, 3};
  return fit;
}

Subject subject_with(std::vector<std::uint64_t> counts) {
  Subject subject{"t.csv", "t.csv", 1, 1, {}, {}, {}, {}, {}};
  subject.counts = OrderCounts{"t.csv", 1, counts, {}, {}, {}, {}, {}};
  subject.measured.orders = measure_orders(*subject.counts);
  return subject;
}

Findings findings_of(std::vector<FamilyFit> fits) {
  Findings findings;
  findings.best = Model::parse("patricia(0.25)");
  findings.fit = FittedDatum{"t", "orders", 99, "counts", std::move(fits)};
  return findings;
}

std::string words_of(const Subject& subject, const Findings& findings) {
  return fmt::format("{}", fmt::join(plain_words(subject, findings), "\n"));
}

TEST(PlainWords, SayWhichFamiliesAreAsGoodBehindAndOut) {
  const std::string words =
      words_of(subject_with({100, 25, 5, 1}), findings_of({fit_with("patricia", 10), fit_with("dst", 11.9),
                                                           fit_with("aldous", 12.1), fit_with("bst", 20.1)}));
  EXPECT_NE(words.find("The table has 100 tips and 4 orders"), std::string::npos) << words;
  EXPECT_NE(words.find("a factor of 4.67 (mean of the ratios"), std::string::npos) << words;
  EXPECT_NE(
      words.find(
          "Of 4 families of models that were fitted the best, by AIC, is patricia with p = 0.250 +- 0.01"
          " (95 % interval 0.230 .. 0.270)."),
      std::string::npos)
      << words;
  EXPECT_NE(words.find("cannot tell it from dst, whose"), std::string::npos) << words;
  EXPECT_NE(words.find("Behind, but not out: aldous."), std::string::npos) << words;
  EXPECT_NE(words.find("worse by more than 10: bst."), std::string::npos) << words;
  EXPECT_NE(words.find("an ordinary one in what was fitted (p = 0.4, by chi-square)"), std::string::npos)
      << words;
  EXPECT_NE(words.find("counts of streams fix the ratio and little more"), std::string::npos) << words;
}

TEST(PlainWords, DoNotJudgeAFitThatDidNotConverge) {
  Findings findings = findings_of({fit_with("patricia", 10), fit_with("dst", 11)});
  findings.fit->fits[1].converged = false;
  const std::string words = words_of(subject_with({100, 25, 5, 1}), findings);
  EXPECT_NE(words.find("did not converge: dst."), std::string::npos) << words;
  EXPECT_EQ(words.find("cannot tell it from"), std::string::npos) << words;
}

TEST(PlainWords, DoNotPraiseAFamilyThatDoesNotFit) {
  Findings findings = findings_of({fit_with("patricia", 10)});
  findings.fit->fits[0].goodness.p_value = 0.001;
  const std::string words = words_of(subject_with({100, 25, 5, 1}), findings);
  EXPECT_NE(words.find("none of these families describes it."), std::string::npos) << words;
  EXPECT_EQ(words.find("ordinary"), std::string::npos);
}

TEST(PlainWords, NameStatisticsThatDepartTheFarthestFirst) {
  Subject subject = subject_with({100, 25, 5, 1});
  Findings findings = findings_of({fit_with("patricia", 10)});
  const StatisticColumn height(statistic::height), width(statistic::width);
  findings.compared = {{height, 12, 10, 1, 0.01, 0.02, true, false},
                       {width, 4, 10, 2, 0.001, 0.002, true, false}};
  const std::string words = words_of(subject, findings);
  EXPECT_NE(
      words.find(
          "departs in width (3.0 standard deviations below) and height (2.0 standard deviations above)"),
      std::string::npos)
      << words;
  for (auto& of : findings.compared) of.adjusted_p = 0.2;
  EXPECT_NE(words_of(subject, findings).find("In none of 2 statistics"), std::string::npos);
}

TEST(PlainWords, OfASingleTipAreFew) {
  Findings findings;
  findings.why_no_fit = "Too small.";
  EXPECT_EQ(
      words_of(subject_with({1}), findings),
      "The table has 1 tip and 1 order of Horton-Strahler; with one order there is no ratio.\nToo small.");
}

TEST(ReportCommands, AreWhatAShellReads) {
  EXPECT_EQ(shell_word("data/walnut.csv"), "data/walnut.csv");
  EXPECT_EQ(shell_word("my tree's"), "'my tree'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
  ReportRequest request{{"-x.csv"}, "7", "random", {}};
  Subject subject = subject_with({4, 2, 1});
  subject.file = "-x.csv";
  EXPECT_EQ(measure_command(subject, request, " --table summary"), "ramify measure ./-x.csv --table summary");
  subject.tree.emplace();
  subject.of = 3;
  EXPECT_EQ(draw_command(subject, request), "ramify draw --tree ./-x.csv --root 7 --which 1 -o tree.svg");
  EXPECT_EQ(
      test_command(subject, request, "aldous(-1)"),
      "ramify test ./-x.csv --root 7 --resolve random --model 'aldous(-1)' --replicates 999 --seed 1996");
}

}  // namespace
}  // namespace ramify
