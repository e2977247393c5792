#include <array>
#include <cstdlib>

#include "support/tree_files.hpp"
#include <gtest/gtest.h>
#include <zlib.h>

#include "ramify/core/error.hpp"
#include "ramify/format/gunzip.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/tree/contract_unary.hpp"
#include "ramify/tree/measure.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

using test::refusal_of;
using test::tree_of;
using test::trees_of;

TEST(Detection, GoesByContent) {
  const struct {
    const char* text;
    TreeFormat format;
  } cases[] = {
      {"(a,b);", TreeFormat::newick},
      {"  [&R](a,b);", TreeFormat::newick},
      {"'a':1;", TreeFormat::newick},
      {"A;", TreeFormat::newick},
      {"((a));", TreeFormat::newick},
      {"(EE)", TreeFormat::parens},
      {"(E(EE", TreeFormat::parens},
      {"E\n(EE)\n", TreeFormat::parens},
      {"# x\n1 0 0 0 0 1 -1\n", TreeFormat::swc},
      {"1 2\n", TreeFormat::edges},
      {"id,parent\n", TreeFormat::edges},
      {"id,parent,length,radius\n", TreeFormat::qsm},
      {"id,toid\n", TreeFormat::flowlines},
      {"COMID,TOCOMID,lengthkm\n", TreeFormat::flowlines},
      {"{\"parent\":[-1]}", TreeFormat::json},
      {"CODE : FORM-A\n", TreeFormat::mtg},
  };
  for (const auto& c : cases) EXPECT_EQ(detect_tree_format(SourceText(c.text, "f")), c.format) << c.text;
}

TEST(Detection, RefusesWhatIsNoTree) {
  EXPECT_EQ(refusal_of("").find("f:1:1: an empty file"), 0u);
  EXPECT_EQ(refusal_of(" \n\r\n").find("f:1:1: an empty file"), 0u);
  EXPECT_EQ(refusal_of(std::string("\x7f"
                                   "ELF\0\0",
                                   6))
                .find("f:1:5: a binary file"),
            0u);
  EXPECT_EQ(refusal_of("BSD 3-Clause License\n").find("f:1:1: not a file of trees"), 0u);
  EXPECT_EQ(refusal_of("\nsome text; and more\n").find("f:2:1: not a file of trees"), 0u);
  EXPECT_EQ(refusal_of("#NEXUS\nbegin trees;").find("f:2:13: the text ends within a NEXUS command"), 0u);
  EXPECT_EQ(refusal_of("order,count\n1,5\n2,1\n").find("f:1:1: not a file of trees"), 0u);
}

TEST(Detection, UnknownNamesAreRefused) {
  EXPECT_EQ(parse_tree_format("auto"), std::nullopt);
  EXPECT_EQ(parse_tree_format("swc"), TreeFormat::swc);
  EXPECT_THROW(parse_tree_format("newik"), Error);
}

TEST(Gunzip, UnpacksSeveralMembersAndRefusesHalves) {
  std::string packed;
  for (const std::string& text : {std::string("(a,"), std::string("b);\n")}) {
    z_stream stream{};
    ASSERT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 31, 8, Z_DEFAULT_STRATEGY), Z_OK);
    std::array<unsigned char, 100> block;
    std::string copy = text;
    stream.next_in = reinterpret_cast<unsigned char*>(copy.data());
    stream.avail_in = static_cast<unsigned>(copy.size());
    stream.next_out = block.data();
    stream.avail_out = block.size();
    ASSERT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
    packed.append(reinterpret_cast<const char*>(block.data()), stream.total_out);
    deflateEnd(&stream);
  }
  ASSERT_TRUE(is_gzip(packed));
  EXPECT_EQ(gunzip(packed, "f"), "(a,b);\n");
  EXPECT_THROW(gunzip(packed.substr(0, packed.size() - 3), "f"), Error);
  EXPECT_THROW(gunzip(packed.substr(0, 2), "f"), Error);
}

TEST(Words, AreReadLineByLine) {
  const auto trees = trees_of("(EE)\n\n ((EE)E)\r\n");
  ASSERT_EQ(trees.size(), 2u);
  EXPECT_EQ(trees[1].name, "f:3");
  EXPECT_EQ(refusal_of("(EE)\n(EX)\n").find("f:2:3: not a tree"), 0u);
  EXPECT_EQ(refusal_of("(EE)\n(E\n").find("f:2:2: not a tree"), 0u);
}

TEST(JsonTrees, AreReadLineByLine) {
  const auto trees = trees_of(
      "{\"parent\":[-1,0,0],\"length\":[1,null,2.5],\"label\":[\"a\",null,\"c\"]}\n{\"parent\":[-1]}\n");
  ASSERT_EQ(trees.size(), 2u);
  EXPECT_EQ(to_parentheses(trees[0].tree), "(EE)");
  EXPECT_EQ(trees[0].lengths[2], 2.5);
  EXPECT_EQ(trees[0].names[2], "c");
}

TEST(JsonTrees, RefuseWithLineAndColumn) {
  const struct {
    const char* text;
    const char* says;
  } cases[] = {
      {"{\"parent\":[-1,0,0}", "f:1:18: not a line of JSON"},
      {"{\"parent\":[-1]}\n{", "f:2:"},
      {"{\"children\":[]}", "f:1:1: no list \"parent\""},
      {"{\"parent\":[]}", "f:1:1: a tree of no nodes"},
      {"{\"parent\":[-1,-1]}", "f:1:1: a second root"},
      {"{\"parent\":[0]}", "f:1:1: the first node has a parent"},
      {"{\"parent\":[-1,2,0]}", "f:1:1: node 1 is not in preorder"},
      {"{\"parent\":[-1,0,0,1]}", "f:1:1: node 3 is not in preorder"},
      {"{\"parent\":[-1,0.5]}", "f:1:1: parent 0.5"},
      {"{\"parent\":[-1],\"length\":[1,2]}", "f:1:1: \"length\" is not a list of 1 values"},
      {"{\"parent\":[-1],\"length\":[\"x\"]}", "f:1:1: length \"x\""},
      {"{\"parent\":[-1],\"length\":[1e999]}", "f:1:1: a number out of range"},
  };
  for (const auto& c : cases) EXPECT_EQ(refusal_of(c.text).find(c.says), 0u) << c.text << refusal_of(c.text);
}

std::vector<std::uint64_t> streams_of(RecordedTree tree) {
  HortonStrahler orders;
  const RecordedTree contracted = contract_unary(std::move(tree));
  const auto top = measure(contracted.tree, orders);
  const auto counts = orders.streams();
  return {counts.begin(), counts.begin() + top + 1};
}

struct KnownFormat {
  const char* file;
  std::vector<std::uint64_t> streams;
};

TEST(MeasuredTrees, HaveTheirKnownStreams) {
  RAMIFY_NEEDS_SHARED_FILES();
  const std::vector<KnownFormat> known{
      {"walnut_branches.csv", {1868, 596, 182, 50, 16, 6, 1}},
      {"apple_braeburn_branches.csv", {279, 52, 7, 1}},
      {"airway_human_ct.swc", {83, 31, 12, 4, 2, 1}},
      {"airway_human_ct_branches.csv", {83, 31, 12, 4, 2, 1}},
      {"river_new_hope_flowlines.csv", {144, 36, 11, 3, 1}},
      {"phylo_hiv1_193.newick", {193, 60, 21, 7, 2, 1}},
      {"phylo_apg_angiosperms_1566.newick", {1566, 417, 107, 31, 7, 2, 1}},
      {"neuron_neurom_bio000_axon_branches.csv", {255, 76, 19, 6, 2, 1}},
      {"walnut_branch_boutdenoylum2.mtg", {58, 18, 3, 1}},
  };
  for (const auto& [file, streams] : known) {
    const std::string path = test::shared_file(file);
    Remarks remarks;
    auto trees = read_trees(read_tree_file(path), path, std::nullopt, {}, remarks);
    ASSERT_EQ(trees.size(), 1u) << file;
    EXPECT_EQ(streams_of(trees.front()), streams) << file;
  }
}

TEST(MeasuredTrees, TheAxonIsOneOfSevenNeurites) {
  RAMIFY_NEEDS_SHARED_FILES();
  const std::string path = test::shared_file("neuron_neurom_bio000.swc");
  const std::string text = read_tree_file(path);
  EXPECT_NE(refusal_of(text).find("7 roots"), std::string::npos);
  EXPECT_EQ(trees_of(text, {"all", 0}).size(), 7u);
  EXPECT_EQ(streams_of(tree_of(text, {"1", 0})), (std::vector<std::uint64_t>{255, 76, 19, 6, 2, 1}));
}

TEST(MeasuredTrees, TheMtgHasTheVerticesItSays) {
  RAMIFY_NEEDS_SHARED_FILES();
  const std::string path = test::shared_file("walnut_branch_boutdenoylum2.mtg");
  EXPECT_EQ(tree_of(read_tree_file(path)).tree.node_count(), 198u);
}

}  // namespace
}  // namespace ramify
