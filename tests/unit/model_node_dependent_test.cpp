#include <cmath>
#include <string>

#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/core/error.hpp"
#include "ramify/model/node_dependent.hpp"
#include "ramify/model/preset.hpp"
#include "ramify/model/registry.hpp"

namespace ramify {
namespace {

double value(const char* text, const NodePlace& node) {
  return Formula(text, "formula")(node);
}

TEST(Formula, KnowsTheNodeAndNaturalLogarithms) {
  const NodePlace node{50, 3, 200};
  EXPECT_EQ(value("d", node), 3);
  EXPECT_EQ(value("n/size", node), 4);
  EXPECT_EQ(value("size >= n/5 ? 1 : 10", node), 1);
  EXPECT_EQ(value("size < n/5 || d == 3 ? 7 : 8", node), 7);
  EXPECT_DOUBLE_EQ(value("1/(3.19+log(d))", node), 1 / (3.19 + std::log(3.0)));
  EXPECT_DOUBLE_EQ(value("max(d,5)^2 + exp(-d)", node), 25 + std::exp(-3.0));
  EXPECT_TRUE(std::isinf(value("1/(d-3)", node)));
}

TEST(Formula, CopiesDoNotShareTheirNode) {
  Formula first("d+size", "formula");
  Formula second(first);
  EXPECT_EQ(first({1, 1, 1}), 2);
  EXPECT_EQ(second({10, 20, 30}), 30);
  EXPECT_EQ(first({1, 2, 1}), 3);
}

std::string formula_refusal(const std::string& text, Size n = 100) {
  return test::error_of([&] { Model::parse(text).require_size(n); });
}

TEST(NodeDependent, SaysWhatIsWrongWithAFormula) {
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(formula_refusal(text).find(part), std::string::npos) << formula_refusal(text);
  };
  says("node_beta(d+,1)", "node_beta: A = 'd+' (Unexpected end");
  says("node_beta(1,x)", "node_beta: B = 'x' (Unexpected token");
  says("node_dst((d)", "Missing parenthesis");
  says("node_dst(d*(1)", "Missing parenthesis");
  says("node_dst(0.1", "a '(' without its ')'");
  says("node_dst()", "node_dst: P = '' (");
  says("node_dst(0.1,0.2)", "node_dst takes 1");
  says("node_dst(size=3 ? 0.1 : 0.2)", "'=' would assign");
  for (const char* text : {"node_dst(size==3 ? 0.1 : 0.2)", "node_dst(size>=3 && d<=4 && d!=2 ? 0.1 : 0.2)",
                           "node_beta( d , max(d, 2) )"})
    EXPECT_EQ(formula_refusal(text), "") << text;
}

TEST(NodeDependent, SaysWhereAFormulaLeavesItsDomain) {
  EXPECT_NE(formula_refusal("node_beta(d-1,1)").find("A = 'd-1' is 0 at d = 1, size = 100, n = 100"),
            std::string::npos);
  EXPECT_NE(formula_refusal("node_beta(5-d,1)").find("is 0 at d = 5"), std::string::npos);
  EXPECT_NE(formula_refusal("node_beta(1/(size-2),1)").find("is inf at d = 2, size = 2"), std::string::npos);
  EXPECT_NE(formula_refusal("node_dst(d/10)").find("is 1 at d = 10"), std::string::npos);
  EXPECT_NE(formula_refusal("node_ternary(0.3+d/100)").find("(0,1/3]"), std::string::npos);
  EXPECT_EQ(formula_refusal("node_beta(1/(size-1),1)"), "");  // size 1 leaves no choice
  EXPECT_EQ(formula_refusal("node_beta(5-d,1)", 4), "");      // no node of depth 5 has a choice
  // A place that is not tried out is found when it is grown.
  const Model model = Model::parse("node_dst(size == 777 ? 2 : 0.5)");
  model.require_size(1001);
  EXPECT_NO_THROW(model.require_size(100));
  Stream stream({1, 2}, 3);
  const Cancellation never;
  EXPECT_NO_THROW(model.grown().grow(700, stream, never));
  EXPECT_THROW(model.grown().grow(777, stream, never), Error);
}

TEST(NodeDependent, TriesPlacesThatTreesHave) {
  EXPECT_TRUE(trial_places(1).empty());
  for (const Size n : {Size{2}, Size{3}, Size{50}, max_double_size}) {
    bool root = false;
    for (const NodePlace& place : trial_places(n)) {
      EXPECT_GE(place.size, 2u);
      EXPECT_LE(place.size + place.depth - 1, n);
      EXPECT_EQ(place.n, n);
      root = root || (place.depth == 1 && place.size == n);
    }
    EXPECT_TRUE(root);
    EXPECT_LT(trial_places(n).size(), 30'000u);
  }
}

TEST(NodeDependent, IsToldApartByItsFormulas) {
  EXPECT_TRUE(Model::parse("node_beta(d,d+1)") == Model::parse("node_beta( d, d + 1 )"));
  EXPECT_FALSE(Model::parse("node_beta(d,d+1)") == Model::parse("node_beta(d+1,d)"));
  EXPECT_NE(Model::parse("node_beta(d,1)").stream_cell(9), Model::parse("node_beta(1,d)").stream_cell(9));
  EXPECT_EQ(Model::parse("node_beta( d , 1 )").text(), "node_beta(d,1)");
}

TEST(Presets, AreModelsOfTheirSize) {
  for (const Preset& preset : presets()) {
    EXPECT_NO_THROW(Model::parse(preset.model).require_size(preset.n)) << preset.name;
    EXPECT_EQ(&find_preset(preset.name), &preset);
    EXPECT_FALSE(preset.source.empty());
  }
  EXPECT_THROW(find_preset("aple"), Error);
}

}  // namespace
}  // namespace ramify
