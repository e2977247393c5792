// Families fitted to counts of streams, as a user sees it.
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(FitOfCounts, RanksFamiliesAndSaysWhatTheyRestOn) {
  const Ran ran = ramify("fit data/new_hope_creek.csv --model aldous,catalan,bst --format csv");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto lines = lines_of(ran.out);
  ASSERT_EQ(lines.size(), 5u) << ran.out;
  EXPECT_TRUE(
      lines[0].starts_with("data,model,parameter,estimate,standard_error,lower,upper,observable,n,rank"));
  EXPECT_TRUE(lines[1].starts_with("new_hope_creek,catalan,,,,,,orders,143,1,")) << lines[1];
  EXPECT_TRUE(lines[2].starts_with("new_hope_creek,aldous,beta,-1.45")) << lines[2];
  EXPECT_TRUE(lines[3].starts_with("new_hope_creek,aldous,horton_ratio,3.9")) << lines[3];
  EXPECT_TRUE(lines[4].starts_with("new_hope_creek,bst,,,,,,orders,143,3,")) << lines[4];
  EXPECT_NE(lines[2].find("from counts of orders 1..2 and the order"), std::string::npos) << lines[2];
}

TEST(FitOfCounts, IsTheSameOnAnyNumberOfThreads) {
  expect_same_on_any_threads("fit data/new_hope_creek.csv --model aldous,patricia --bootstrap 60");
}

TEST(FitOfCounts, ATableForReadingHasTheBestFamilyFirst) {
  const Ran ran = ramify("fit data/new_hope_creek.csv --model bst,catalan --format table");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(ran.out.starts_with("new_hope_creek, n 143, from counts of orders 1..2")) << ran.out;
  EXPECT_LT(ran.out.find("catalan"), ran.out.find("bst"));
}

TEST(FitOfCounts, AFamilyWithMoreParametersThanOrdersIsListedWithTheReason) {
  const Scratch scratch;
  const std::string table = scratch.file("few.csv", "order,count\n1,40\n2,11\n3,2\n4,1\n");
  const Ran ran = ramify("fit --model beta,bst --format csv " + table);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("few,beta,,,,,,orders,39,2,,,,,,,,,,,,not_fitted,1 order above the tips"),
            std::string::npos)
      << ran.out;
}

TEST(FitOfCounts, TreesThatAreTooSmallAreRefused) {
  const Scratch scratch;
  const std::string table = scratch.file("tiny.csv", "order,count\n1,7\n2,2\n3,1\n");
  const Ran ran = ramify("fit --model bst " + table);
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("takes 21 tips and 3 orders at least"), std::string::npos) << ran.err;
}

TEST(FitOfCounts, ABootstrapSaysWhetherASimplerFamilySuffices) {
  const Ran ran =
      ramify("fit data/new_hope_creek.csv --model patricia,ford,bst,catalan --bootstrap 60 --format csv");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("misfit_p,likelihood_ratio,bootstrap_trees"), std::string::npos);
  std::vector<std::string> tests;
  for (const std::string& line : lines_of(ran.out))
    if (line.find("_suffices,") != std::string::npos) tests.push_back(line);
  ASSERT_EQ(tests.size(), 2u) << ran.out;
  EXPECT_TRUE(tests[0].starts_with("new_hope_creek,ford,bst_suffices,0.0163934,")) << tests[0];
  EXPECT_TRUE(tests[1].starts_with("new_hope_creek,ford,catalan_suffices,0.")) << tests[1];
  const Ran without = ramify("fit data/new_hope_creek.csv --model ford,bst,catalan --format csv");
  EXPECT_EQ(without.out.find("suffices"), std::string::npos);
}

TEST(FitOfCounts, TheCurveOfEquivalentShapesIsATableAndAPicture) {
  const Scratch scratch;
  const std::string curve = (scratch / "curve.csv").string(), plot = (scratch / "curve.svg").string();
  const Ran ran = ramify("fit data/new_hope_creek.csv --model beta_multinomial,bst --format csv --curve " +
                         curve + " --plot " + plot);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("--curve lists the pairs that fit nearly as well"), std::string::npos) << ran.out;
  const auto lines = lines_of(read_file(curve));
  ASSERT_EQ(lines.size(), 27u);
  EXPECT_EQ(lines[0], "data,model,a,b,horton_ratio,log_likelihood,below_best,place");
  EXPECT_TRUE(lines[1].starts_with("new_hope_creek,beta_multinomial,0.")) << lines[1];
  EXPECT_NE(read_file(plot).find("<svg"), std::string::npos);
}

TEST(FitOfCounts, HubersLossNamesTheOddOrder) {
  const Ran ran = ramify("fit data/walnut.csv --model aldous --robust --format csv");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("Huber's loss beyond 1.345 standard deviations: order 3 (-1.8) counts less"),
            std::string::npos)
      << ran.out;
}

/// What is grown by order has another likelihood, which is not ranked with that given n.
TEST(FitOfTrees, FamiliesGivenTheOrderAreRankedApart) {
  const Scratch scratch;
  const std::string tree = scratch.file("tree.newick", "(((((a,b),c),((d,e),f)),z),((g,h),(i,(j,k))));");
  const Ran ran = ramify("fit --format csv --model bst,tokunaga,catalan,ramification " + tree);
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::size_t of_size = 0, of_order = 0, first = 0;
  for (const auto& line : lines_of(ran.out)) {
    of_size += line.find(",tree,") != std::string::npos ? 1 : 0;
    of_order += line.find(",tree given order,") != std::string::npos ? 1 : 0;
    first += line.find("11,1,") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(of_size, 2u) << ran.out;
  EXPECT_EQ(of_order, 3u + 9u) << ran.out;  // a, c, the ratio; rows of 2, 3 and 4 shares
  EXPECT_GE(first, 2u) << ran.out;          // each kind has its best
  const Ran read = ramify("fit --format table --model bst,tokunaga " + tree);
  EXPECT_NE(read.out.find("AIC is not to be compared with that of families given n"), std::string::npos)
      << read.out;
}

TEST(FitOfTrees, ATreeTooSmallForTokunagaNamesTheSmallest) {
  const Scratch scratch;
  const std::string tree = scratch.file("tree.newick", "((a,b),(c,d));");
  const Ran ran = ramify("fit --model tokunaga " + tree);
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("order 2, 0 side branches: a and c take order 2 (leaf order 0) and a side branch, 4 "
                         "nodes at least"),
            std::string::npos)
      << ran.err;
}

TEST(FitOfTrees, ATableOfTheOrdersThatMeetSaysAsMuchAsTheTree) {
  const Scratch scratch;
  const std::string table =
      scratch.file("sapling.csv", read_file(RAMIFY_SOURCE "/data/sapling_orders_that_meet.csv"));
  const std::string bootstrap = " --format csv --bootstrap 40 ";
  const Ran tree = ramify("fit data/examples/sapling.newick --model tokunaga,ramification" + bootstrap);
  const Ran counted = ramify("fit " + table + bootstrap);
  ASSERT_EQ(counted.code, 0) << counted.err;
  EXPECT_EQ(counted.out, tree.out);
  const Ran refused = ramify("fit " + table + " --model patricia");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("no fit of patricia (a table of the orders that meet"), std::string::npos)
      << refused.err;
  EXPECT_EQ(ramify("fit --observable orders " + table).code, 2);
}

TEST(FitOfCounts, OfTokunagaNumbersCountsFixTheRatio) {
  const Ran ran = ramify("fit data/walnut.csv --format csv --model tokunaga,ramification");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_NE(ran.out.find("walnut,tokunaga,horton_ratio,3."), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("counts do not say which orders meet"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace ramify::test
