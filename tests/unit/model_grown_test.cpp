#include <cmath>
#include <string>

#include "support/error_of.hpp"
#include "support/scratch.hpp"
#include "support/uninterrupted.hpp"
#include <gtest/gtest.h>

#include "ramify/model/ramification.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

std::string word_of(const char* text, Size n) {
  const Model model = Model::parse(text);
  model.require_size(n);
  Stream stream({1, 2}, 3);
  return to_parentheses(model.grown().grow(n, stream, test::uninterrupted));
}

std::string refused_model(const char* text, Size n = 1) {
  return test::error_of([&] { Model::parse(text).require_size(n); });
}

TEST(Kary, IsComplete) {
  EXPECT_EQ(word_of("kary(3)", 1), "E");
  EXPECT_EQ(word_of("kary(3)", 3), "((EEE)(EEE)(EEE))");
  EXPECT_EQ(Model::parse("kary(3)").grown().expected_nodes(3), 13);
  EXPECT_NE(refused_model("kary(2.5)").find("whole number"), std::string::npos);
  EXPECT_NE(refused_model("kary(3)", 40).find("nodes"), std::string::npos);
}

TEST(FlowRate, SplitsEvenlyOrLeavesAStem) {
  EXPECT_EQ(word_of("flow_rate(1)", 3), "((EE)(EE))");
  EXPECT_EQ(word_of("flow_rate(1e-9)", 4), "(E(E(EE)))");
  EXPECT_NE(refused_model("flow_rate(1.5)").find("(0,1]"), std::string::npos);
}

TEST(Branching, IsCompleteOrAChain) {
  EXPECT_EQ(word_of("branching(0,0,1)", 3), "((EE)(EE))");
  EXPECT_EQ(word_of("branching(0,1,0)", 3), "((E))");
  EXPECT_EQ(word_of("branching(1,0,0)", 3), "E");
  EXPECT_NE(refused_model("branching(0.2,0.2,0.2)").find("sum to 0.6"), std::string::npos);
  EXPECT_NE(refused_model("branching(-0.2,0.2,1)").find("not negative"), std::string::npos);
  EXPECT_NE(refused_model("branching(0,0,1)", 40).find("stored"), std::string::npos);
}

TEST(GaltonWatson, RefusesSizesThatNoTreeHas) {
  EXPECT_NE(refused_model("galton_watson(0.5,0,0.5)", 4).find("odd"), std::string::npos);
  EXPECT_NE(refused_model("galton_watson(0.5,0,0.5)", 0).find("one node"), std::string::npos);
  EXPECT_NE(refused_model("galton_watson(0.5,0.5,0)").find("p2"), std::string::npos);
}

TEST(Ternary, RefusesAMainChildThatIsNotTheLargest) {
  EXPECT_NE(refused_model("ternary(0.4)").find("1/3"), std::string::npos);
  EXPECT_EQ(refused_model("ternary(1/3)"), "");
}

// A17: E_k = 1.6667, 6.3333, 20.75, 66.2381, 211.6703 for k = 2..6 of leaf order 1.
TEST(Ramification, KnowsItsMeanSizes) {
  const Ramification matrix(read_ramification_matrix(RAMIFY_SOURCE_DIR "/data/ramification_bst.csv"),
                            "matrix");
  EXPECT_EQ(matrix.largest_size(), 5u);
  const double internal[] = {0, 1.6667, 6.3333, 20.75, 66.2381, 211.6703};
  for (Size k = 0; k <= 5; ++k) EXPECT_NEAR((matrix.expected_nodes(k) - 1) / 2, internal[k], 5e-5);
}

// Leaves of a critical Galton-Watson tree of order K, leaf order 1: (2 4^(K-1) + 1)/3.
TEST(Tokunaga, OfOneAndTwoHasTheSizesOfCriticalTrees) {
  const Ramification matrix(tokunaga_matrix(1, 2), "matrix");
  for (Size k = 0; k <= 20; ++k)
    EXPECT_NEAR((matrix.expected_nodes(k) + 1) / 2, (2 * std::pow(4.0, static_cast<double>(k)) + 1) / 3,
                1e-12 * matrix.expected_nodes(k));
}

TEST(Ramification, SaysWhichRowIsWrong) {
  const test::Scratch scratch;
  const auto read = [&](const std::string& text) {
    const std::string path = scratch.file("matrix.csv", text);
    return test::error_of([&] { Ramification(read_ramification_matrix(path), path); });
  };
  EXPECT_NE(
      read("order,side,probability\n2,1,0.4\n2,2,0.5\n").find("row of order 1 (the probabilities sum to 0.9"),
      std::string::npos);
  EXPECT_NE(read("order,side,probability\n2,1,1\n").find("p(1,1) is 0"), std::string::npos);
  EXPECT_NE(read("order,side,probability\n2,3,1\n").find(".csv:2:3: side 3"), std::string::npos);
  EXPECT_NE(read("order,side,probability\n2,2,1\n2,2,1\n").find(".csv:3: p(2,2) again"), std::string::npos);
  EXPECT_NE(read("order,side,probability,leaf_order\n2,2,1,2\n").find("leaf_order 2"), std::string::npos);
  EXPECT_NE(read("order,side\n2,2\n").find("probability"), std::string::npos);
  EXPECT_NE(read("order,side,probability\n").find("no rows"), std::string::npos);
  EXPECT_EQ(read("order,side,probability,leaf_order\n1,0,0.5,0\n1,1,0.5,0\n"), "");
}

TEST(GrownModels, AreToldApart) {
  EXPECT_TRUE(Model::parse("trie(1/4)") == Model::parse("trie(0.25)"));
  EXPECT_FALSE(Model::parse("trie(0.25)") == Model::parse("ternary(0.25)"));
  EXPECT_FALSE(Model::parse("trie(0.25)") == Model::parse("patricia(0.25)"));
  EXPECT_NE(Model::parse("trie(0.25)").stream_cell(9), Model::parse("ternary(0.25)").stream_cell(9));
  EXPECT_EQ(Model::parse("trie(0.25)").stream_cell(9), Model::parse("trie(1/4)").stream_cell(9));
}

}  // namespace
}  // namespace ramify
