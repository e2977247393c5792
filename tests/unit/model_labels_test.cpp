#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <vector>

#include "support/uninterrupted.hpp"
#include <gtest/gtest.h>

#include "ramify/model/labelled_tree.hpp"
#include "ramify/model/split_tree.hpp"
#include "ramify/tree/store.hpp"

namespace ramify {
namespace {

LabelledTree grown(const Model& model, Size n) {
  Stream stream({1, 2}, 3);
  return grow_labelled(model, n, stream, test::uninterrupted);
}

/// Whether combine(labels of the children) is the label of every node that has some.
template <class Combine>
void expect_labels(std::string_view text, Size n, std::string_view meaning, Combine combine) {
  const auto [tree, labels, named] = grown(Model::parse(text), n);
  EXPECT_EQ(named, meaning) << text;
  ASSERT_EQ(labels.size(), tree.node_count()) << text;
  std::vector<std::uint64_t> open;  // labels of roots, the nearest last
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    std::vector<std::uint64_t> children;
    for (std::uint32_t i = 0; i < tree.arity(node); ++i) {
      children.push_back(open.back());
      open.pop_back();
    }
    if (!children.empty()) {
      EXPECT_TRUE(combine(labels[node], children)) << text << ", node " << node;
    }
    open.push_back(labels[node]);
  }
}

TEST(LabelledTree, TellsWhatTheGrammarKnewOfItsNodes) {
  const auto one_more = [](std::uint64_t label, const auto& below) {
    return label == std::accumulate(below.begin(), below.end(), std::uint64_t{1});
  };
  const auto sum = [](std::uint64_t label, const auto& below) {
    return label == std::accumulate(below.begin(), below.end(), std::uint64_t{0});
  };
  const auto next = [](std::uint64_t label, const auto& below) { return label == below[0] + 1; };
  constexpr std::string_view sizes = "internal nodes from it down";
  for (const char* text : {"bst", "patricia(0.3)", "ternary(0.2)", "node_beta(d,2)"})
    expect_labels(text, 200, sizes, one_more);
  expect_labels("trie(0.3)", 200, "strings below", sum);
  expect_labels("kary(3)", 5, "levels from it on", next);
  expect_labels("branching(0.1,0.2,0.7)", 8, "generations from it on, its own counted", next);
  expect_labels("tokunaga(1,2)", 5, "order, leaf order 0", [](std::uint64_t label, const auto& below) {
    return below[0] == below[1] ? label == below[0] + 1 : label == std::max(below[0], below[1]);
  });
}

TEST(LabelledTree, IsTheTreeWithoutLabels) {
  for (const char* text : {"ternary(0.2)", "galton_watson(0.3,0.4,0.3)"}) {
    const Model model = Model::parse(text);
    Stream stream({1, 2}, 3);
    EXPECT_EQ(grown(model, 100).tree, model.grown().grow(100, stream, test::uninterrupted)) << text;
  }
  Stream stream({1, 2}, 3);
  EXPECT_EQ(grown(Model::parse("catalan"), 100).tree, grow_tree(SplitTree<Catalan>(Catalan()), 100, stream));
  EXPECT_TRUE(grown(Model::parse("galton_watson(0.3,0.4,0.3)"), 100).labels.empty());
}

}  // namespace
}  // namespace ramify
