// A page about somebody's own tree or table, as a user gets it.
#include <string>

#include "program.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

/// The commands that a page in Markdown shows.
std::vector<std::string> commands_on(const std::string& page) {
  std::vector<std::string> found;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("    ramify ")) found.push_back(line.substr(11));
  return found;
}

TEST(ReportVerb, OfATreeHasEverySectionAndCommandsThatRun) {
  const Scratch scratch;
  const Ran ran = ramify("report data/examples/sapling.swc --format md");
  ASSERT_EQ(ran.code, 0) << ran.err;
  for (const char* section :
       {"# Report on sapling.swc\n", "## In plain words\n", "## Picture\n", "## Orders\n", "## Ratios\n",
        "## Which model is it like?\n", "## Where it departs from the best model\n"})
    EXPECT_TRUE(holds(ran.out, section)) << section;
  EXPECT_TRUE(holds(ran.out, "The tree has 8 tips and 3 orders")) << ran.out;
  EXPECT_TRUE(holds(ran.out, "| 1 | 8 | 8 |")) << ran.out;
  EXPECT_TRUE(holds(
      ran.out, "| streams, divided by (R_B) | 2.833 ± 0.097 | 2.75 ± 0.12 | 2.828 ± 0.096 | 2.828 ± 0.096 |"))
      << ran.out;
  EXPECT_TRUE(holds(ran.out, "| mean radius, times (R_D) |")) << ran.out;
  EXPECT_TRUE(holds(ran.out, "Murray's exponent, fork by fork: 2.999, the median over 7 forks")) << ran.out;
  const auto commands = commands_on(ran.out);
  EXPECT_EQ(commands.size(), 7u);
  for (const auto& command : commands) {
    if (command.starts_with("report ")) continue;
    // The whole command, from a folder where it may write; fits of families that a tree of 7 nodes cannot
    // tell end with exit code 3.
    const Ran again = shell("cd " + scratch.path().string() + " && ln -sfn " RAMIFY_SOURCE "/data data && " +
                            RAMIFY_PROGRAM + " " + command);
    EXPECT_TRUE(again.code == 0 || (again.code == 3 && command.starts_with("fit "))) << command << again.err;
  }
}

TEST(ReportVerb, HtmlIsOneFileThatNeedsNoNetwork) {
  const Scratch scratch;
  const std::string file = (scratch / "page.html").string();
  const Ran ran = ramify("report data/examples/sapling.newick -o " + file);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  const std::string html = read_file(file);
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
  EXPECT_TRUE(html.ends_with("</html>\n"));
  EXPECT_FALSE(holds(html, "http"));
  EXPECT_FALSE(holds(html, "<script"));
  std::size_t pictures = 0;
  for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 2u);
  EXPECT_TRUE(holds(html, "aria-label=\"Node-link diagram with the root at the left: 8 tips"));
  EXPECT_TRUE(holds(html, "Made by ramify"));
}

TEST(ReportVerb, RatiosHaveTheErrorsOfHorton) {
  const Ran page = ramify("report data/new_hope_creek.csv --format md --model catalan");
  const Ran table = ramify("horton data/new_hope_creek.csv --model catalan --seed 1996 --csv");
  ASSERT_EQ(page.code, 0) << page.err;
  ASSERT_EQ(table.code, 0) << table.err;
  std::string row = "| streams, divided by (R_B) |", biases;
  for (const char* estimator : {"mean_ratio", "pooled_ratio", "regression", "geometric"}) {
    std::istringstream lines(table.out);
    for (std::string line; std::getline(lines, line);)
      if (holds(line, fmt::format(",R_B,{},", estimator))) {
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        row += fmt::format(" {:.4g} ± {:.2g} |", std::stod(cells.at(5)), std::stod(cells.at(6)));
        biases += fmt::format("{:+.2g} ", std::stod(cells.at(8)));
      }
  }
  EXPECT_TRUE(holds(page.out, row)) << row << '\n' << page.out;
  std::istringstream each(biases);
  for (std::string bias; each >> bias;) EXPECT_TRUE(holds(page.out, bias)) << bias;
  EXPECT_TRUE(holds(page.out, "from 400 trees of catalan, fitted to the counts"));
}

TEST(ReportVerb, IsTheSameOnAnyNumberOfThreads) {
  expect_same_on_any_threads("report data/examples/sapling.txt --format md");
}

TEST(ReportVerb, OfATableOfCountsHasNoPictureButItsFits) {
  const Ran ran = ramify("report data/new_hope_creek.csv --format md --model aldous,catalan,bst");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_FALSE(holds(ran.out, "## Picture"));
  EXPECT_FALSE(holds(ran.out, "departs"));
  EXPECT_TRUE(holds(ran.out, "the best, by AIC, is catalan (no parameter).")) << ran.out;
  EXPECT_TRUE(
      holds(ran.out, "    ramify fit data/new_hope_creek.csv --model aldous,catalan,bst --seed 1996\n"));
  EXPECT_TRUE(holds(ran.out, "counts of streams fix the ratio and little more")) << ran.out;
}

TEST(ReportVerb, SeveralSubjectsHaveSectionsOfTheirOwn) {
  const Scratch scratch;
  const std::string trees = scratch.file("two.txt", "((EE)(E(EE)))\n(E(EE))\n");
  const Ran ran = ramify("report " + trees + " --format md --bootstrap 0");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(holds(ran.out, "### In plain words\n"));
  EXPECT_TRUE(holds(ran.out, " --which 2 -o tree.svg\n")) << ran.out;
  EXPECT_TRUE(holds(ran.out, "The tree is too small: trees of every family are alike")) << ran.out;
}

TEST(ReportVerb, SaysWhatItCouldNotDo) {
  const Scratch scratch;
  const std::string wide = scratch.file("wide.newick", "((a,b,c),(d,(e,f)));\n");
  const Ran ran = ramify("report " + wide + " --format md");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(holds(ran.out, "The tree has 1 fork of three branches or more")) << ran.out;
  EXPECT_FALSE(holds(ran.out, "ramify fit"));
  const Ran resolved = ramify("report " + wide + " --format md --resolve ladder");
  ASSERT_EQ(resolved.code, 0) << resolved.err;
  EXPECT_TRUE(holds(resolved.out, "--resolve ladder --model")) << resolved.out;
  const std::string leaf = scratch.file("leaf.txt", "E\n");
  const Ran single = ramify("report " + leaf + " --format md");
  EXPECT_EQ(single.code, 0) << single.err;
  EXPECT_TRUE(holds(single.out, "1 tip and 1 order")) << single.out;
  const std::string small = scratch.file("small.csv", "order,count\n1,7\n2,2\n3,1\n");
  EXPECT_TRUE(
      holds(ramify("report " + small + " --format md").out, "too small to fit anything to it: 7 tips"));
}

TEST(ReportVerb, MarkupInANameIsNoMarkupOnThePage) {
  const Scratch scratch;
  scratch.file("<b>&'.txt", "((EE)(E(EE)))\n");
  const Ran ran =
      shell("cd " + scratch.path().string() + " && " RAMIFY_PROGRAM " report \"<b>&'.txt\" --bootstrap 0");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(holds(ran.out, "<title>Report on &lt;b&gt;&amp;'.txt</title>"));
  EXPECT_FALSE(holds(ran.out, "<b>"));
}

TEST(ReportVerb, RefusesInOneLine) {
  for (const std::string line :
       {"report no_such_file.csv", "report data/walnut.csv --format pdf",
        "report data/walnut.csv --replicates 5", "report data/walnut.csv --bootstrap 3",
        "report data/walnut.csv --model bts", "report data/species.csv"}) {
    const Ran ran = ramify(line);
    EXPECT_EQ(ran.code, 2) << line;
    EXPECT_EQ(count_lines(ran.err), 1u) << line << ran.err;
    EXPECT_EQ(ran.out, "");
  }
}

}  // namespace
}  // namespace ramify::test
