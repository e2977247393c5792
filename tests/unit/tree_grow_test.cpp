#include <string>
#include <vector>

#include "support/definitions.hpp"
#include "support/growing.hpp"
#include "support/seed.hpp"
#include <gtest/gtest.h>

#include "ramify/core/error.hpp"
#include "ramify/sample/tree_sampler.hpp"
#include "ramify/tree/grow.hpp"
#include "ramify/tree/measure.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using test::seed_of;

using Deterministic = Joint<Height, HortonStrahler, FillLevel, Balance>;

class EveryModel : public ::testing::TestWithParam<std::string> {};

// The tree that is measured while it grows is the tree that is stored, and both are measured alike.
TEST_P(EveryModel, GrowsTheTreeItStores) {
  const Model model = Model::parse(GetParam());
  const Cancellation never;
  const auto full = make_tree_sampler({model, whole_trees(orders_and_paths), max_size, &never});
  const auto lean = make_tree_sampler({model, whole_trees(orders_and_height), max_size, &never});
  const std::uint64_t seed = seed_of("grown and stored");
  TreeMeasures streamed, quick;
  for (const Size n : {0u, 1u, 2u, 3u, 7u, 50u, 127u, 128u, 129u, 130u, 1000u, 20000u}) {
    const StreamKey key{seed, model.stream_cell(n)};
    const auto store = test::tree_source(GetParam(), key, test::default_tables);
    for (std::uint64_t replicate = 0; replicate < (n > 5000 ? 3u : 20u); ++replicate) {
      full->sample(n, key, replicate, streamed);
      lean->sample(n, key, replicate, quick);
      const Tree tree = store(n, replicate);
      Deterministic fold;
      const auto root = measure(tree, fold);
      ASSERT_EQ(tree.size(), n);
      ASSERT_EQ(tree.node_count(), 2 * n + 1);
      EXPECT_EQ(streamed.size, n);
      EXPECT_EQ(streamed.height, get<0>(root));
      EXPECT_EQ(streamed.strahler, get<1>(root));
      EXPECT_EQ(streamed.fill_level, get<2>(root));
      EXPECT_EQ(streamed.balance, get<3>(root));
      EXPECT_EQ(streamed.nodes, fold.get<HortonStrahler>().nodes());
      EXPECT_EQ(streamed.streams, fold.get<HortonStrahler>().streams());
      EXPECT_EQ(quick.size, n);
      EXPECT_EQ(quick.height, streamed.height);
      EXPECT_EQ(quick.strahler, streamed.strahler);
      EXPECT_EQ(quick.nodes, streamed.nodes);
      EXPECT_EQ(quick.streams, streamed.streams);
      EXPECT_LT(streamed.depth, streamed.height);
    }
  }
}

// A grown tree against the definitions: every statistic of trees of 40 nodes, the depth among its possible
// values.
TEST_P(EveryModel, MeasuresByTheDefinitions) {
  const Model model = Model::parse(GetParam());
  const Cancellation never;
  const auto sampler = make_tree_sampler({model, whole_trees(orders_and_paths), max_size, &never});
  const StreamKey key{seed_of("definitions"), model.stream_cell(40)};
  const auto store = test::tree_source(GetParam(), key, test::default_tables);
  for (std::uint64_t replicate = 0; replicate < 20; ++replicate) {
    TreeMeasures measures;
    sampler->sample(40, key, replicate, measures);
    const auto shape = test::read_shape(to_parentheses(store(40, replicate)));
    EXPECT_EQ(measures.strahler, test::strahler(shape));
    EXPECT_EQ(measures.height, test::height(shape));
    EXPECT_EQ(measures.fill_level, test::fill_level(shape));
    EXPECT_EQ(measures.balance, test::balance(shape));
    EXPECT_EQ(test::last_node_depth_law(shape).count(measures.depth), 1u);
    const auto nodes = test::nodes_per_order(shape), streams = test::streams_per_order(shape);
    for (std::size_t k = 0; k < HortonStrahler::orders; ++k) {
      EXPECT_EQ(measures.nodes[k], k < nodes.size() ? nodes[k] : 0);
      EXPECT_EQ(measures.streams[k], k < streams.size() ? streams[k] : 0);
    }
  }
}

TEST_P(EveryModel, ReplaysOneTreeAlone) {
  const Model model = Model::parse(GetParam());
  const Cancellation never;
  const auto sampler = make_tree_sampler({model, whole_trees(orders_and_paths), max_size, &never});
  const auto other = sampler->clone();
  const StreamKey key{seed_of("replay"), model.stream_cell(300)};
  TreeMeasures in_order, alone;
  for (std::uint64_t replicate = 0; replicate < 5; ++replicate)
    sampler->sample(300, key, replicate, in_order);
  other->sample(300, key, 4, alone);
  EXPECT_EQ(in_order.nodes, alone.nodes);
  EXPECT_EQ(in_order.height, alone.height);
  EXPECT_EQ(in_order.depth, alone.depth);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, ::testing::ValuesIn(test::all_models()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name;
                         });

using LeanFold = Joint<Height, HortonStrahler>;
using ChainGrower = Grower<SplitTree<FixedSplit>, LeanFold, Stream>;

// 24 bytes a level: the label, its sibling and 8 bytes of values. A segment of 4096 slots has one that is not
// used.
TEST(Grower, KeepsAChainOfTenMillionLevelsIn24BytesALevel) {
  const Size n = 10000000;
  const Cancellation never;
  ChainGrower grower(never);
  LeanFold fold;
  Stream stream({0, 0}, 0);
  const auto root = grower(SplitTree<FixedSplit>(FixedSplit(1e-9)), n, stream, fold);
  EXPECT_EQ(get<0>(root), n + 1);
  EXPECT_EQ(get<1>(root), 1u);
  EXPECT_EQ(fold.get<HortonStrahler>().nodes()[1], n);
  constexpr std::size_t segment = 4096 * 24;
  EXPECT_LE(grower.stack_bytes(), 24 * n * 4096 / 4095 + segment);
  EXPECT_GE(grower.stack_bytes(), 24 * (n - 1));
}

TEST(Grower, KeepsNoStackForWhatIsDone) {
  const Cancellation never;
  Grower<SplitTree<Bst>, LeanFold, Stream> grower(never);
  LeanFold fold;
  Stream stream({seed_of("small stack"), 0}, 0);
  grower(SplitTree<Bst>(Bst()), 1000000, stream, fold);
  EXPECT_LE(grower.stack_bytes(), 4096u * 24u);
}

TEST(Grower, StopsWhenItIsCancelledAndOnlyThen) {
  Cancellation cancellation;
  Grower<SplitTree<Bst>, LeanFold, Stream> grower(cancellation);
  const SplitTree<Bst> grammar{Bst()};
  LeanFold fold;
  Stream stream({seed_of("cancelled"), 0}, 0);
  EXPECT_NO_THROW(grower(grammar, 4000000, stream, fold));
  cancellation.request();
  EXPECT_THROW(grower(grammar, 4000000, stream, fold), Interrupted);
}

TEST(Grower, LooksForCancellationAcrossSmallTreesToo) {
  Cancellation cancellation;
  cancellation.request();
  Grower<SplitTree<Bst>, LeanFold, Stream> grower(cancellation);
  const SplitTree<Bst> grammar{Bst()};
  LeanFold fold;
  Stream stream({seed_of("cancelled, small"), 0}, 0);
  const auto grow_many = [&] {
    for (int i = 0; i < 40000; ++i) grower(grammar, 100, stream, fold);
  };
  EXPECT_THROW(grow_many(), Interrupted);
}

TEST(Measure, NeedsNoRecursion) {
  const std::size_t deep = 1000000;
  std::vector<std::uint32_t> word;
  for (std::size_t i = 0; i < deep; ++i) word.insert(word.end(), {2, 0});
  word.push_back(0);
  const Tree right_chain(word);
  for (std::size_t i = 0; i < deep; ++i) word[i] = 2, word[deep + i] = 0;
  const Tree left_chain(word);
  for (const Tree* tree : {&right_chain, &left_chain}) {
    Deterministic fold;
    const auto root = measure(*tree, fold);
    EXPECT_EQ(get<0>(root), deep + 1);
    EXPECT_EQ(get<1>(root), 1u);
    EXPECT_EQ(get<2>(root), 1u);
    EXPECT_EQ(fold.get<HortonStrahler>().nodes()[1], deep);
    EXPECT_EQ(fold.get<HortonStrahler>().streams()[1], 1u);
  }
}

TEST(SegmentedStack, IsAStackAcrossSegments) {
  SegmentedStack<std::uint64_t> stack;
  EXPECT_TRUE(stack.empty());
  for (int round = 0; round < 2; ++round) {
    for (std::uint64_t i = 0; i < 20000; ++i) stack.push(i);
    for (std::uint64_t i = 20000; i-- > 3;) {
      ASSERT_EQ(stack.top(), i);
      stack.pop();
    }
    EXPECT_FALSE(stack.empty());
    stack.clear();
    EXPECT_TRUE(stack.empty());
  }
  EXPECT_EQ(stack.capacity_bytes(), 5u * 4096u * 8u);
}

}  // namespace
}  // namespace ramify
