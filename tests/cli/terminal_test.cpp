// What a person at a terminal sees, and what a pipe does not.
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

/// Run on a terminal of its own (util-linux's script), whose transcript comes back as output.
Ran on_terminal(const std::string& arguments) {
  return shell("script -qec \"" + std::string(RAMIFY_PROGRAM) + " " + arguments + "\" /dev/null");
}

bool has_terminals() {
  return shell("command -v script").code == 0;
}

TEST(Terminal, ShowsWorkFromItsThirdSecondOn) {
  if (!has_terminals()) GTEST_SKIP() << "no script (util-linux)";
  const std::string timed = "timeout -s INT 3.5 ";
  const Ran seen = shell("script -qec \"" + timed + RAMIFY_PROGRAM +
                         " law --model bst --n 3e5 --statistic depth --exact\" /dev/null");
  EXPECT_NE(seen.out.find("\rlaw: 2 s"), std::string::npos) << seen.out;
  const Ran grown = shell("script -qec \"" + timed + RAMIFY_PROGRAM +
                          " sample --model bst --n 1e6 --no-graft --replicates 3000\" /dev/null");
  EXPECT_NE(grown.out.find(" s left"), std::string::npos) << grown.out;
  const Scratch scratch;
  const Ran drawn = shell("script -qec \"" + timed + RAMIFY_PROGRAM + " draw --model bst --n 2e6 -o " +
                          (scratch / "tree.png").string() + "\" /dev/null");
  EXPECT_NE(drawn.out.find("\rdraw: 2 s"), std::string::npos) << drawn.out;
  EXPECT_EQ(on_terminal("sample --model bst --n 10").out.find("\rsample"), std::string::npos);
}

TEST(Terminal, ShowsTablesAligned) {
  if (!has_terminals()) GTEST_SKIP() << "no script (util-linux)";
  const std::string theory = "theory --model bst";
  EXPECT_NE(on_terminal(theory).out.find("model  constant"), std::string::npos) << on_terminal(theory).out;
  EXPECT_EQ(on_terminal(theory + " --csv").out.substr(0, 15), "model,constant,");
  EXPECT_EQ(ramify(theory).out.substr(0, 15), "model,constant,");
  const Scratch scratch;
  const std::string counts = scratch.file("counts.csv", "order,count\n1,9\n2,3\n3,1\n");
  const Ran orders = on_terminal("measure " + counts);
  EXPECT_EQ(orders.out.find("nodes"), std::string::npos) << "a column without a value: " << orders.out;
  EXPECT_NE(on_terminal("fit --observable ratio --format auto --n 20 " + counts).out.find("at the rule"),
            std::string::npos);
}

TEST(Terminal, GetsNoPageOfHtml) {
  if (!has_terminals()) GTEST_SKIP() << "no script (util-linux)";
  const Ran html = on_terminal("report data/examples/sapling.newick");
  EXPECT_EQ(html.code, 2) << html.out;
  EXPECT_NE(html.out.find("add -o report.html"), std::string::npos) << html.out;
  EXPECT_EQ(on_terminal("report data/examples/sapling.newick --format md --bootstrap 0").code, 0);
}

TEST(Terminal, ShowsAPValueThatIsABoundAsOne) {
  if (!has_terminals()) GTEST_SKIP() << "no script (util-linux)";
  const Scratch scratch;
  const std::string chain = (scratch / "chain").string();
  ASSERT_EQ(ramify("sample --model chain --n 300 --format parens -o " + chain).code, 0);
  const std::string test = "test --model bst --replicates 199 " + chain;
  const Ran seen = on_terminal(test);
  EXPECT_NE(seen.out.find("< 1e-20"), std::string::npos) << seen.out;
  EXPECT_NE(seen.out.find("< 2/200"), std::string::npos) << seen.out;
  const std::string table = ramify(test).out;
  EXPECT_NE(table.find(",1e-20,"), std::string::npos) << table;
  EXPECT_NE(table.find(",\"exact law, p_value a bound\""), std::string::npos) << table;
  EXPECT_NE(table.find(",0.01,"), std::string::npos) << table;
  EXPECT_EQ(table.find(",0,"), table.find(",strahler,0,") + 9)
      << "no p-value is 0, and the leaf order is: " << table;
}

TEST(Terminal, APipeThatIsClosedEndsTheProgramQuietly) {
  const Ran ran =
      shell("( " + std::string(RAMIFY_PROGRAM) +
            " sample --model bst --n 10 --replicates 100000; echo $? >&2 ) | head -n 1 >/dev/null");
  EXPECT_EQ(ran.err, "141\n");
}

}  // namespace
}  // namespace ramify::test
