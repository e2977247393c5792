// What does not fit into memory is refused before it begins, and what is offered in its place does fit.
#include "program.hpp"
#include "support/sanitized.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

/// "ramify <arguments>" with 400 MB of address space.
Ran within_400_megabytes(const std::string& arguments) {
  return shell("ulimit -v 400000; " + std::string(RAMIFY_PROGRAM) + " " + arguments);
}

struct Large {
  const char* name;
  std::string arguments;  ///< without the size
  const char* size;       ///< "--n"
  const char* much = "1e9";
  const char* output = "/dev/null";

  friend std::ostream& operator<<(std::ostream& out, const Large& large) { return out << large.name; }
};

class MemoryLimit : public testing::TestWithParam<Large> {};

TEST_P(MemoryLimit, IsSaidWithWhatWouldFitAndThatDoes) {
  if (sanitized) GTEST_SKIP() << "a sanitizer maps more than any limit";
  const auto& [name, arguments, size, much, output] = GetParam();
  const Scratch scratch;  // a drawing has a name of its own
  const std::string writing = " -o " + (scratch.path() / output).string();
  const Ran refused = within_400_megabytes(arguments + " " + size + " " + much + writing);
  EXPECT_EQ(refused.code, 2) << refused.err;
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(count_lines(refused.err), 1u) << refused.err;
  const std::string offer = std::string("take ") + size + " ";
  const auto at = refused.err.find(offer);
  ASSERT_NE(at, std::string::npos) << refused.err;
  const std::string fits =
      refused.err.substr(at + offer.size(), refused.err.find(' ', at + offer.size()) - at - offer.size());
  const Ran ran = within_400_megabytes(arguments + " " + size + " " + fits + writing);
  EXPECT_EQ(ran.code, 0) << fits << '\n' << ran.err;
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, MemoryLimit,
    testing::Values(Large{"Newick", "sample --model bst --format newick", "--n"},
                    Large{"Parens", "sample --model bst --format parens", "--n"},
                    Large{"Edges", "sample --model bst --format edges", "--n"},
                    Large{"Swc", "sample --model bst --format swc", "--n"},
                    Large{"Json", "sample --model bst --format json", "--n"},
                    Large{"GrownTrees", "sample --model 'ternary(0.2)' --format newick", "--n", "1e8"},
                    Large{"Drawing", "draw --model bst", "--n", "2e6", "tree.png"},
                    Large{"ManyTrees", "sample --model bst --n 100 --format parens", "--replicates"},
                    Large{"GrownWhole", "sample --model 'node_beta(d,d)'", "--n", "1e8"},
                    Large{"DeepTree", "sample --model chain --statistics height", "--n"},
                    Large{"DeepTreeOfEverything",
                          "sample --model chain --statistics height,balance,streams,sackin,colless,b2",
                          "--n"},
                    Large{"ManyRows", "sample --model bst --n 3", "--replicates"},
                    Large{"NodesOfATrie", "trie --nodes", "--n"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(MemoryLimit, OfARunIsSaidBeforeItBegins) {
  if (sanitized) GTEST_SKIP() << "a sanitizer maps more than any limit";
  const Scratch scratch;
  const std::string config = scratch.file(
      "chain.toml", "models=[\"chain\"]\nn=[10,1000000000]\nreplicates=1\nstatistics=[\"height\"]\n");
  const Ran ran = within_400_megabytes("run " + config + " --out " + (scratch / "o").string());
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
  EXPECT_NE(ran.err.find("of memory"), std::string::npos) << ran.err;
  EXPECT_FALSE(std::filesystem::exists(scratch / "o"));
}

/// What nobody has estimated ends in one line too.
TEST(MemoryLimit, OfATreeThatIsReadIsOneLine) {
  if (sanitized) GTEST_SKIP() << "a sanitizer maps more than any limit";
  const Scratch scratch;
  const std::string tree = (scratch / "tree").string();
  ASSERT_EQ(ramify("sample --model bst --n 4e6 --format newick -o " + tree).code, 0);
  for (const char* verb : {"measure ", "test --model bst "}) {
    const Ran ran = shell("ulimit -v 150000; " + std::string(RAMIFY_PROGRAM) + " " + verb + tree);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
    EXPECT_NE(ran.err.find("out of memory"), std::string::npos) << ran.err;
  }
}

}  // namespace
}  // namespace ramify::test
