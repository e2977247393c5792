// Horton's ratios as a user sees them, and what is refused of tables of counts.
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

TEST(Horton, ShowsEveryEstimatorWithItsError) {
  const Ran ran = ramify("horton data/new_hope_creek.csv --model catalan --trees 100");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(
      ran.out.starts_with("data,quantity,estimator,first_order,last_order,value,standard_error,"
                          "error_from,bias,bias_from,model,trees,outlying,note\n"));
  for (const char* row :
       {"R_B,mean_ratio,1,5,", "R_B,regression_below_top,1,4,", "R_B,regression_inner,2,4,",
        "R_B,pooled_ratio_dense,1,2,4,", "R_L,regression,1,5,", ",law,", ",limit,catalan,100,"})
    EXPECT_NE(ran.out.find(row), std::string::npos) << row << '\n' << ran.out;
}

TEST(Horton, IsTheSameOnAnyNumberOfThreads) {
  expect_same_on_any_threads("horton data/new_hope_creek.csv --model aldous --trees 100");
}

TEST(Horton, ReadsTreesAndAreas) {
  const Ran tree = ramify("horton data/examples/sapling.swc --leaf-order 0");
  ASSERT_EQ(tree.code, 0) << tree.err;
  EXPECT_NE(tree.out.find("murray_exponent,forks,,,"), std::string::npos) << tree.out;
  const Scratch scratch;
  const std::string table = scratch.file("a.csv", "order,count,area\n1,16,1\n2,4,5\n3,1,25\n");
  const Ran areas = ramify("horton " + table);
  ASSERT_EQ(areas.code, 0) << areas.err;
  EXPECT_NE(areas.out.find("R_A,regression,1,3,5,"), std::string::npos) << areas.out;
  EXPECT_NE(ramify("measure " + table).out.find(",16,1\n"), std::string::npos);
}

TEST(Horton, FewTreesAreRefused) {
  const Ran ran = ramify("horton data/walnut.csv --trees 10");
  EXPECT_EQ(ran.code, 2);
  EXPECT_NE(ran.err.find("take 40 or more"), std::string::npos) << ran.err;
}

// What cannot be the counts of a tree names file, row and column.
TEST(Horton, BadTablesAreRefusedWithTheirPlace) {
  const Scratch scratch;
  const struct {
    const char *text, *place, *says;
  } cases[] = {{"order,count\n1,10\n2,12\n", ":3:3: ", "streams become fewer"},
               {"order,count\n1,10\n2,0\n", ":3:3: ", "count 0"},
               {"order,count\n1,10\n", ":2:1: ", "two orders"},
               {"order,count\n1,10\n2,3.5\n", ":3:3: ", "not a whole number"},
               {"order,count\n1,10\n2,nan\n", ":3:3: ", "nan"},
               {"order,count\n1,10\n2,-3\n", ":3:3: ", "not a whole number"},
               {"order,count,length\n1,10,1\n2,3,-1\n", ":3:5: ", "the length of streams is positive"},
               {"order,count,area\n1,10,1\n2,3,0\n", ":3:5: ", "the area of streams is positive"},
               {"order,count\n1,10\n3,2\n", ":3:1: ", "order 2 comes here"}};
  for (const char* verb : {"horton ", "measure ", "fit "})
    for (const auto& [text, place, says] : cases) {
      const std::string table = scratch.file("bad.csv", text);
      const Ran ran = ramify(verb + table);
      EXPECT_EQ(ran.code, 2) << text;
      EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
      EXPECT_NE(ran.err.find("bad.csv" + std::string(place)), std::string::npos) << ran.err;
      EXPECT_NE(ran.err.find(says), std::string::npos) << ran.err;
    }
}

TEST(Horton, LinksGivenAsStreamsAreNotFitted) {
  const Scratch scratch;
  const std::string table =
      scratch.file("links.csv", "order,count\n1,726\n2,356\n3,171\n4,144\n5,45\n6,11\n");
  const Ran fit = ramify("fit --model bst " + table);
  EXPECT_EQ(fit.code, 2);
  EXPECT_NE(fit.err.find("links.csv:5:3: count 144 after 171"), std::string::npos) << fit.err;
  const Ran horton = ramify("horton " + table);
  EXPECT_EQ(horton.code, 0);
  EXPECT_NE(horton.out.find("no binary tree has 144 streams above 171"), std::string::npos) << horton.out;
}

}  // namespace
}  // namespace ramify::test
