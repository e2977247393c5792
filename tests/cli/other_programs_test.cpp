// Trees that are written open in the programs they are written for, where these are installed.
#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

/// Three ternary trees of 20 internal nodes, with 41 tips each, and a trie of 30 strings with one-child
/// nodes.
std::string newick_file(const Scratch& scratch) {
  const std::string file = (scratch / "trees.newick").string();
  EXPECT_EQ(ramify("sample --model 'ternary(0.2)' --n 20 --replicates 3 --format newick -o " + file).code, 0);
  EXPECT_EQ(
      shell(std::string(RAMIFY_PROGRAM) + " sample --model 'trie(0.3)' --n 30 --format newick >> " + file)
          .code,
      0);
  return file;
}

TEST(OtherPrograms, ApeReadsOurNewick) {
  if (shell("Rscript -e 'library(ape)'").code != 0) GTEST_SKIP() << "R has no ape here";
  const Scratch scratch;
  const Ran ran = shell("Rscript -e 'library(ape); cat(sapply(read.tree(\"" + newick_file(scratch) +
                        "\"), function(t) length(t$tip.label)))'");
  EXPECT_EQ(ran.out, "41 41 41 30") << ran.err;
}

TEST(OtherPrograms, DendroPyReadsOurNewick) {
  const std::string python =
      shell("/usr/bin/python3 -c 'import dendropy'").code == 0 ? "/usr/bin/python3" : "python3";
  if (shell(python + " -c 'import dendropy'").code != 0) GTEST_SKIP() << "Python has no DendroPy here";
  const Scratch scratch;
  const Ran ran = shell(python +
                        " -c \"import dendropy; print([len(t.leaf_nodes()) for t in "
                        "dendropy.TreeList.get(path='" +
                        newick_file(scratch) + "', schema='newick')])\"");
  EXPECT_EQ(ran.out, "[41, 41, 41, 30]\n") << ran.err;
}

TEST(OtherPrograms, ApeWritesWhatWeRead) {
  if (shell("Rscript -e 'library(ape)'").code != 0) GTEST_SKIP() << "R has no ape here";
  const Scratch scratch;
  const std::string file = (scratch / "ape.newick").string();
  const Ran written =
      shell("Rscript -e 'library(ape); set.seed(1); write.tree(rtree(100), \"" + file + "\")'");
  ASSERT_EQ(written.code, 0) << written.err;
  const Ran ran = ramify("measure " + file);
  EXPECT_NE(ran.out.find(",1,1,100,100,"), std::string::npos) << ran.out << ran.err;
}

}  // namespace
}  // namespace ramify::test
