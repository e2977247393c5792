// ramify measure: tables of trees that somebody else has written.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "program.hpp"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ramify::test {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream row(line);
  for (std::string field; std::getline(row, field, ',');) fields.push_back(field);
  return fields;
}

/// A column of a table, by name.
std::vector<std::string> column(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  const auto header = cells(line);
  const auto place = static_cast<std::size_t>(std::find(header.begin(), header.end(), name) - header.begin());
  std::vector<std::string> values;
  while (std::getline(lines, line)) {
    const auto row = cells(line);
    values.push_back(place < row.size() ? row[place] : "no such column");
  }
  return values;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

TEST(Measure, OrdersOfEveryExample) {
  const Ran ran = ramify("measure data/examples/*");
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::size_t files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(RAMIFY_SOURCE) + "/data/examples")) {
    const Ran one = ramify("measure " + entry.path().string());
    EXPECT_EQ(joined(column(one.out, "streams")), "8 3 1") << entry.path() << one.err;
    EXPECT_EQ(joined(column(one.out, "nodes")), "8 5 2") << entry.path();
    EXPECT_EQ(joined(column(one.out, "order")), "1 2 3") << entry.path();
    ++files;
  }
  EXPECT_GE(files, 7u);
}

TEST(Measure, GeometryStandsWhereTheFileHasIt) {
  EXPECT_EQ(ramify("measure data/examples/sapling.newick --leaf-order 0").out,
            "tree,leaf_order,order,nodes,streams,mean_length\n"
            "data/examples/sapling.newick,0,0,8,8,27.125\n"
            "data/examples/sapling.newick,0,1,5,3,67.66666667\n"
            "data/examples/sapling.newick,0,2,2,1,195\n");
  const Ran both = ramify("measure data/examples/sapling.txt data/examples/sapling_qsm.csv");
  EXPECT_EQ(both.out.substr(0, both.out.find('\n')),
            "tree,leaf_order,order,nodes,streams,mean_length,mean_radius");
  EXPECT_NE(both.out.find("data/examples/sapling.txt,1,1,8,8,,\n"), std::string::npos) << both.out;
  EXPECT_NE(both.out.find("data/examples/sapling_qsm.csv,1,1,8,8,27.125,2\n"), std::string::npos) << both.out;
}

TEST(Measure, LevelsAreTheProfile) {
  const Scratch scratch;
  const std::string file = scratch.file("one.newick", "((a,b),(c,(d,e)));\n");
  EXPECT_EQ(ramify("measure --table levels " + file).out, "tree,depth,nodes,external_nodes\n" + file +
                                                              ",1,1,0\n" + file + ",2,2,0\n" + file +
                                                              ",3,4,3\n" + file + ",4,2,2\n");
}

TEST(Measure, SummaryHasARowForEveryTree) {
  const Scratch scratch;
  const std::string file = scratch.file("two.newick", "(a,(b,c));\n((a,b),(c,d));\n");
  const Ran ran = ramify("measure --table summary " + file);
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(joined(column(ran.out, "tree")), file + ":1 " + file + ":2");
  EXPECT_EQ(joined(column(ran.out, "strahler")), "2 3");
  EXPECT_EQ(joined(column(ran.out, "size")), "2 3");
  EXPECT_EQ(joined(column(ran.out, "streams_3")), "0 1");
  EXPECT_EQ(joined(column(ran.out, "nodes_mean_ratio")), "1.5 2");
  EXPECT_EQ(joined(column(ran.out, "nodes_pooled_ratio")), "1.5 2");
  EXPECT_EQ(joined(column(ran.out, "ramification_2_1")), "0.5 0");
  EXPECT_EQ(joined(column(ran.out, "tokunaga_1")), "1 0");
  EXPECT_EQ(joined(column(ramify("measure --leaf-order 0 --table summary " + file).out, "strahler")), "1 2");
}

TEST(Measure, JsonHasEverything) {
  const Ran ran = ramify("measure --table json data/examples/sapling_edges.csv");
  const auto tree = nlohmann::json::parse(ran.out).at(0);
  EXPECT_EQ(tree.at("statistics").at("streams"), (std::vector<int>{8, 3, 1}));
  EXPECT_EQ(tree.at("statistics").at("ramification").at(1).size(), 3u);
  EXPECT_NEAR(tree.at("streams_ratio_estimators").at("mean_ratio").get<double>(), (8.0 / 3 + 3) / 2, 1e-9);
  EXPECT_NEAR(tree.at("streams_ratio_estimators").at("pooled_ratio").get<double>(), 11.0 / 4, 1e-9);
  EXPECT_NEAR(tree.at("murray").at("exponent").get<double>(), 3, 0.01);
  EXPECT_NEAR(tree.at("stream_length_law").at("geometric").get<double>(), std::sqrt(195 / 27.125), 1e-8);
}

TEST(Measure, NodesHaveARowEach) {
  const Ran ran = ramify("measure --table nodes data/examples/sapling.newick");
  EXPECT_EQ(count_lines(ran.out), 16u);
  EXPECT_NE(ran.out.find("data/examples/sapling.newick,1,0,trunk,1,3,5,5,1,8,1,0,120,\n"), std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("sapling.newick,3,2,a1,1,1,1,3,3,1,"), std::string::npos) << ran.out;
}

TEST(Measure, OneChildNodesAreContractedUnlessTheyAreToBeKept) {
  const Scratch scratch;
  const std::string file = scratch.file("unary.txt", "((E)(((EE))))\n");
  EXPECT_EQ(joined(column(ramify("measure " + file).out, "nodes")), "3 2");
  EXPECT_EQ(joined(column(ramify("measure --keep-unary " + file).out, "nodes")), "4 4");
}

TEST(Measure, TheRuleForForksOfThree) {
  const Scratch scratch;
  const std::string file = scratch.file("three.txt", "((EE)EE)\n((EE)(EE)E)\n");
  EXPECT_EQ(joined(column(ramify("measure --table summary " + file).out, "strahler")), "2 3");
}

TEST(Measure, ChosenStatisticsAreTheColumnsOfTheSummary) {
  EXPECT_EQ(
      ramify("measure --statistics size,strahler,colless data/examples/sapling.newick").out,
      ramify("measure --table summary --statistic size,strahler,colless data/examples/sapling.newick").out);
  const Scratch scratch;
  const std::string file = scratch.file("trees.txt", "((EE)E)\n((EE)EE)\n");
  const Ran ran = ramify("measure --statistics strahler,colless,streams " + file);
  EXPECT_EQ(ran.out, "tree,leaf_order,strahler,colless,streams_1,streams_2\n" + file + ":1,1,2,1,3,1\n" +
                         file + ":2,1,2,,4,1\n");
  EXPECT_NE(ran.err.find("1 of 2 trees have forks of three or more, " + file + ":2 first, and no colless"),
            std::string::npos)
      << ran.err;
  EXPECT_EQ(ramify("measure --statistics strahler " + file).err, "");
}

TEST(Measure, AForestSaysWhichTreesHaveWideForks) {
  const Scratch scratch;
  const std::string file =
      scratch.file("forest.newick", "((a,b),(c,d));\n(a,b,(c,d,e));\n((a,b,c),(d,e));\n");
  const Ran norms = ramify("measure --table norms " + file);
  EXPECT_EQ(norms.code, 0) << norms.err;
  EXPECT_NE(norms.err.find("2 of 3 trees have forks of three or more, " + file + ":2 first"),
            std::string::npos)
      << norms.err;
  const Ran refused = ramify("test --model bst " + file);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("2 of 3 trees have forks of three or more, first " + file + ":2 with 2 of them"),
            std::string::npos)
      << refused.err;
  for (const char* way : {"ladder", "random"}) {
    const Ran resolved = ramify(std::string("measure --table norms --resolve ") + way + ' ' + file);
    EXPECT_EQ(resolved.err, "");
    EXPECT_NE(resolved.out.find(file + ":2,4,"), std::string::npos) << resolved.out;
    EXPECT_EQ(ramify(std::string("test --replicates 99 --model bst --resolve ") + way + ' ' + file).code, 0);
  }
  EXPECT_EQ(joined(column(ramify("measure --table summary --resolve ladder " + file).out, "strahler")),
            "3 2 3");
  EXPECT_EQ(ramify("measure --resolve comb " + file).code, 2);
}

TEST(Measure, SaysOnceWhatItDoesNotRead) {
  const Scratch scratch;
  const std::string file = scratch.file("cell.swc", "1 1 0 0 0 5 -1 7\n2 3 0 10 0 1 1 7\n");
  for (const char* verb : {"measure ", "measure --table json "}) {
    const Ran ran = ramify(verb + file);
    EXPECT_EQ(ran.code, 0);
    EXPECT_EQ(ran.err, "ramify: warning: " + file + ": ignored: 2 fields after the seventh\n");
  }
}

TEST(Measure, FitReadsWhatItWrites) {
  const Scratch scratch;
  const std::string table = (scratch / "orders.csv").string();
  ASSERT_EQ(ramify("measure data/examples/sapling.newick -o " + table).code, 0);
  const Ran fit = ramify("fit --observable ratio --n 100 --format csv " + table);
  EXPECT_EQ(fit.code, 0) << fit.err;
  EXPECT_NE(fit.out.find("orders:data/examples/sapling.newick,patricia"), std::string::npos) << fit.out;
}

TEST(Measure, ReadsStandardInputAndGzip) {
  const std::string program = RAMIFY_PROGRAM;
  EXPECT_EQ(
      joined(column(shell("gzip -c data/examples/sapling.swc | " + program + " measure -").out, "streams")),
      "8 3 1");
  const Ran cut = shell("gzip -c data/examples/sapling.swc | head -c 100 | " + program + " measure -");
  EXPECT_EQ(cut.code, 2);
  EXPECT_EQ(count_lines(cut.err), 1u) << cut.err;
}

TEST(Measure, CountsOfStreamsAreRecognised) {
  const Scratch scratch;
  const std::string good = scratch.file("walnut.csv",
                                        "order,count,diameter\n1,1868,8.6\n2,596,11.1\n3,182,18\n"
                                        "4,50,30\n5,16,47\n6,6,83\n7,1,184\n");
  const Ran summary = ramify("measure --table summary " + good);
  EXPECT_EQ(joined(column(summary.out, "streams_mean_ratio")), "3.640103355") << summary.err;
  EXPECT_EQ(joined(column(summary.out, "nodes_mean_ratio")), "");
  EXPECT_EQ(summary.err, "");
  EXPECT_EQ(column(ramify("measure " + good).out, "mean_radius").front(), "4.3");
  const std::string links =
      scratch.file("river.csv", "order,count\n1,726\n2,356\n3,171\n4,144\n5,45\n6,11\n");
  const Ran warned = ramify("measure " + links);
  EXPECT_EQ(warned.code, 0);
  EXPECT_NE(warned.err.find("may be links, nodes or Horsfield orders, not streams"), std::string::npos);
  EXPECT_EQ(ramify("measure --table nodes " + links).code, 2);
}

TEST(Measure, WrittenTreesAreReadBack) {
  const Scratch scratch;
  for (const char* model : {"bst", "'trie(0.3)'", "'ternary(0.2)'"}) {
    const std::string what = std::string("sample --n 200 --replicates 3 --model ") + model;
    const std::string whole = ramify(what + " --statistics nodes,streams,colless,height --no-graft").out;
    for (const char* format : {"newick", "edges", "swc", "parens", "json"}) {
      const Ran trees = ramify(what + " --format " + format + " -o " + (scratch / "trees").string());
      ASSERT_EQ(trees.code, 0) << trees.err;
      const std::string root = std::string(format) == "swc" ? " --root all " : " ";
      const Ran read =
          ramify("measure --keep-unary --leaf-order 0 --table summary" + root + (scratch / "trees").string());
      ASSERT_EQ(read.code, 0) << read.err;
      for (const char* name : {"height", "colless", "nodes_0", "nodes_2", "streams_1"})
        EXPECT_EQ(column(read.out, name), column(whole, name)) << model << ' ' << format << ' ' << name;
    }
  }
}

/// Each is a file whose every refusal is one line that begins with its place.
TEST(BadTreeFile, NamesFileLineAndColumn) {
  const Scratch scratch;
  const struct {
    std::string text;
    const char* says;
  } cases[] = {
      {"", "bad:1:1: an empty file"},
      {"((a,b),c", "bad:1:9: the text ends within a tree"},
      {"((a,b)),c);", "bad:1:8: a ',' outside"},
      {"id,parent\n1,2\n2,3\n3,1\n", "bad:2:1: a cycle of 3 nodes"},
      {"id,parent\n1,0\n2,0\n3,0\n", "bad:3:1: 3 roots"},
      {"id,parent\n1,0\n2,1\n2,1\n", "bad:4:1: id 2 twice"},
      {"id,parent\r\n1,0\n2,2\r\n", "bad:3:1: node 2 is its own parent"},
      {"\xEF\xBB\xBFid,parent\n1,9\n", "bad:2:3: parent 9 of node 1 has no row"},
      {std::string("\x89PNG\r\n\x1a\n\0\0", 10), "bad:3:1: a binary file"},
      {std::string("\x1f\x8b\x08\0 this is no gzip", 20), "bad: a gzip file that cannot be unpacked"},
      {"1 0 0 0 0 1e999 -1\n", "bad:1:11: radius = '1e999'"},
      {std::string(5'000'000, '('), "bad:1:5000000: not a tree (5000000 '(' left open)"},
      {std::string(5'000'000, '(') + ",", "bad:1:5000002: the text ends within a tree"},
      {std::string(5'000'000, 'x'), "bad:1:1: not a file of trees"},
      {std::string(5'000'000, ','), "bad:1:1: not a file of trees"},
      {"x" + std::string(5'000'000, ','), "bad:1:10002: a row of more than 10000 fields"},
      {"#NEXUS\n", "bad:2:1: no tree in a NEXUS file"},
      {"order,count\n1,5\n2,7\n", "bad:3:3: count 7"},
  };
  for (const auto& c : cases) {
    const std::string file = scratch.file("bad", c.text);
    for (const char* verb : {"measure ", "measure --table json "}) {
      const Ran ran = ramify(verb + file);
      EXPECT_EQ(ran.code, 2) << c.says << ran.err;
      EXPECT_EQ(ran.out, "");
      EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
      EXPECT_NE(ran.err.find(c.says), std::string::npos) << c.says << '\n' << ran.err;
    }
  }
}

TEST(MeasuredTrees, TheWalnutsRatiosByNodesAndByStreams) {
  const char* shared = std::getenv("RAMIFY_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "RAMIFY_SHARED names no folder of measured trees";
  const std::string trees = std::string(shared) + "/trees/";
  const Ran ran = ramify("measure --table summary " + trees + "walnut_branches.csv");
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(joined(column(ran.out, "nodes_mean_ratio")).substr(0, 4), "2.44");
  EXPECT_EQ(joined(column(ran.out, "streams_mean_ratio")).substr(0, 4), "3.64");
  EXPECT_EQ(joined(column(ramify("measure " + trees + "phylo_hiv1_193.newick").out, "streams")),
            "193 60 21 7 2 1");
}

}  // namespace
}  // namespace ramify::test
