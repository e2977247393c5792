// Every tree that is written is read back as the same tree, left and right included.
#include <cmath>

#include "support/growing.hpp"
#include "support/grown_cases.hpp"
#include "support/shape.hpp"
#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/core/cancellation.hpp"
#include "ramify/format/write_trees.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

RecordedTree plain(Tree tree) {
  RecordedTree recorded;
  recorded.tree = std::move(tree);
  return recorded;
}

Tree grown(const Model& model, Size n, std::uint64_t replicate) {
  return test::grown_tree(model, n, {1996, model.stream_cell(n)}, replicate);
}

class Written : public testing::TestWithParam<TreeFormat> {
 protected:
  static std::vector<RecordedTree> back(const std::vector<RecordedTree>& trees) {
    const ReadOptions options{GetParam() == TreeFormat::swc ? "all" : "", 0};
    return test::trees_of(write_trees(trees, GetParam()), options);
  }

  static void expect_back(const std::vector<RecordedTree>& trees) {
    const auto read = back(trees);
    ASSERT_EQ(read.size(), trees.size());
    for (std::size_t i = 0; i < trees.size(); ++i) EXPECT_EQ(read[i].tree, trees[i].tree);
  }
};

TEST_P(Written, SmallTreesComeBack) {
  std::vector<RecordedTree> trees;
  for (std::size_t n = 0; n <= 5; ++n)
    for (const auto& shape : test::all_shapes(n))
      trees.push_back(plain(from_parentheses(test::to_word(shape))));
  for (const char* word : {"(E)", "(EEE)", "((E)(EEEE)((E)))", "(((E)))"})
    trees.push_back(plain(from_parentheses(word)));
  expect_back(trees);
  for (const auto& tree : trees) expect_back({tree});
}

TEST_P(Written, TreesOfEveryModelComeBack) {
  auto cases = test::grown_cases();
  for (const auto& split : test::all_models()) cases.push_back({split, 300});
  for (const auto& [text, n] : cases) {
    SCOPED_TRACE(text);
    const Model model = Model::parse(text);
    std::vector<RecordedTree> trees;
    for (std::uint64_t replicate = 0; replicate < 4; ++replicate)
      trees.push_back(plain(grown(model, n, replicate)));
    expect_back(trees);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Written, testing::ValuesIn(written_formats()),
                         [](const auto& test) { return std::string(name_of(test.param)); });

TEST(WrittenTables, KeepNamesLengthsAndRadii) {
  RecordedTree tree = plain(from_parentheses("(E(EE))"));
  tree.lengths = {std::nan(""), 0.1, 2, 1e-300, 4};
  tree.radii = {5, 4, 3, std::nan(""), 1.0 / 3};
  const char* names[] = {"trunk, main", "a", "b's", "", "#2;"};
  for (std::size_t node = 0; node < 5; ++node) tree.names.set(node, names[node]);
  for (const TreeFormat format : {TreeFormat::newick, TreeFormat::edges, TreeFormat::json}) {
    SCOPED_TRACE(name_of(format));
    const RecordedTree back = test::tree_of(write_trees({tree}, format));
    for (std::size_t node = 0; node < 5; ++node) {
      EXPECT_TRUE(back.names[node] == names[node] || node == 3) << node;
      EXPECT_TRUE(back.lengths[node] == tree.lengths[node] || node == 0) << node;
      const bool has_radii = format != TreeFormat::newick;
      EXPECT_TRUE(!has_radii || back.radii[node] == tree.radii[node] || node == 3) << node;
    }
    EXPECT_TRUE(std::isnan(back.lengths[0]));
  }
}

TEST(WrittenSwc, HasMurraysRadii) {
  EXPECT_EQ(write_trees({plain(from_parentheses("(E(EE))"))}, TreeFormat::swc),
            "# id type x y z radius parent\n1 1 1 0 0 0.1442 -1\n2 3 0 1 0 0.1 1\n3 3 1.5 1 0 0.126 1\n"
            "4 3 1 2 0 0.1 3\n5 3 2 2 0 0.1 3\n");
}

}  // namespace
}  // namespace ramify
