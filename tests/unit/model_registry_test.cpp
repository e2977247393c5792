#include <set>
#include <string>
#include <variant>
#include <vector>

#include "support/error_of.hpp"
#include "support/growing.hpp"
#include "support/grown_cases.hpp"
#include <gtest/gtest.h>

#include "ramify/core/error.hpp"
#include "ramify/model/registry.hpp"

namespace ramify {
namespace {

std::string model_refusal(std::string_view text) {
  return test::error_of([&] { Model::parse(text); });
}

::testing::AssertionResult says(const std::string& message, std::string_view part) {
  if (message.find('\n') != std::string::npos)
    return ::testing::AssertionFailure() << "more than one line: " << message;
  if (message.find(part) == std::string::npos)
    return ::testing::AssertionFailure() << message << " without " << part;
  return ::testing::AssertionSuccess();
}

TEST(Model, ReadsEveryModel) {
  EXPECT_TRUE(std::holds_alternative<Bst>(Model::parse("bst").law()));
  EXPECT_TRUE(std::holds_alternative<Catalan>(Model::parse("catalan").law()));
  const Model beta = Model::parse(" beta( 10, 80 ) ");
  EXPECT_EQ(beta.text(), "beta(10,80)");
  EXPECT_EQ(beta.name(), "beta");
  EXPECT_EQ(beta.parameters(), (std::vector<double>{10, 80}));
  EXPECT_EQ(std::get<Beta>(beta.law()).b(), 80);
  EXPECT_EQ(std::get<BetaMultinomial>(Model::parse("beta_multinomial(2,1/3)").law()).b(), 1.0 / 3);
  EXPECT_EQ(std::get<Patricia>(Model::parse("patricia(1/4.35)").law()).p(), 1 / 4.35);
  EXPECT_EQ(std::get<Dst>(Model::parse("dst(0.23)").law()).p(), 0.23);
  EXPECT_EQ(std::get<Aldous>(Model::parse("aldous(-3/2)").law()).beta(), -1.5);
  EXPECT_TRUE(std::holds_alternative<Complete>(Model::parse("complete").law()));
  EXPECT_TRUE(std::holds_alternative<Chain>(Model::parse("chain").law()));
  EXPECT_EQ(std::get<FixedSplit>(Model::parse("split(0.25)").law()).x(), 0.25);
}

TEST(Model, RefusesAnUnknownNameWithTheNearest) {
  EXPECT_TRUE(says(model_refusal("patrica(0.3)"), "did you mean patricia?"));
  EXPECT_TRUE(says(model_refusal("dts(0.3)"), "did you mean dst"));
  EXPECT_TRUE(says(model_refusal("quadtree"), "unknown model 'quadtree'"));
  EXPECT_TRUE(says(model_refusal(""), "unknown model ''"));
  EXPECT_TRUE(says(model_refusal("BST"), "unknown model 'BST'"));
}

TEST(Model, RefusesAWrongNumberOfParameters) {
  EXPECT_TRUE(says(model_refusal("bst(1)"), "bst takes 0"));
  EXPECT_TRUE(says(model_refusal("beta(10)"), "beta takes 2"));
  EXPECT_TRUE(says(model_refusal("beta"), "write beta(a,b)"));
  EXPECT_TRUE(says(model_refusal("beta(1,2,3)"), "beta takes 2"));
  EXPECT_TRUE(says(model_refusal("dst"), "dst takes 1"));
  EXPECT_TRUE(says(model_refusal("patricia(0.2,0.3)"), "patricia takes 1"));
  EXPECT_TRUE(says(model_refusal("catalan(0.5)"), "catalan takes 0"));
  EXPECT_TRUE(says(model_refusal("beta(10,80"), "a '(' without its ')'"));
}

TEST(Model, RefusesAParameterThatIsNoNumber) {
  for (const char* text :
       {"dst(x)", "dst()", "dst(nan)", "dst(inf)", "dst(-inf)", "dst(1/0)", "beta(1,inf)", "beta(nan,1)",
        "beta(1,)", "patricia(0.2x)", "dst(0 .2)", "split(1e999)", "dst(0.2))", "beta(1e308/1e-308,1)"})
    EXPECT_TRUE(says(model_refusal(text), "not a finite number")) << text;
}

TEST(Model, RefusesAParameterOutOfItsDomain) {
  for (const char* model : {"dst", "patricia", "split"})
    for (const char* value : {"0", "1", "-0.1", "1.5", "2/1", "-0"})
      EXPECT_TRUE(says(model_refusal(std::string(model) + "(" + value + ")"), "must lie in (0,1)"))
          << model << value;
  for (const char* text : {"beta(0,1)", "beta(1,0)", "beta(-1,1)", "beta(1,-2)", "beta_multinomial(0,1)",
                           "beta_multinomial(1,-2)", "beta(1e100,1e100)", "beta(1,1e-10)"})
    EXPECT_TRUE(says(model_refusal(text), "must lie in [1e-9,1e9]")) << text;
  for (const char* text : {"ford(-0.1)", "ford(1.1)"})
    EXPECT_TRUE(says(model_refusal(text), "must lie in [0,1]")) << text;
  for (const char* text : {"aldous(-2)", "aldous(-3)"})
    EXPECT_TRUE(says(model_refusal(text), "must be a finite number above -2")) << text;
  for (const char* text :
       {"beta(1e-9,1e9)", "aldous(-1.9999999999999998)", "aldous(1e300)", "ford(0)", "ford(1)"})
    EXPECT_EQ(model_refusal(text), "") << text;
}

TEST(Model, RefusesSizesItCannotDraw) {
  const Size limit = Size{1} << 50;
  for (const char* text : {"beta(2,3)", "beta_multinomial(2,3)", "split(0.3)", "dst(0.3)", "patricia(0.3)",
                           "catalan", "aldous(-1)", "ford(0.3)"}) {
    const Model model = Model::parse(text);
    EXPECT_EQ(model.largest_size(), limit);
    EXPECT_NO_THROW(model.require_size(limit));
    EXPECT_THROW(model.require_size(limit + 1), Error);
  }
  for (const char* text : {"bst", "complete", "chain"}) {
    const Model model = Model::parse(text);
    EXPECT_NO_THROW(model.require_size(Size{1} << 62));
    EXPECT_THROW(model.require_size((Size{1} << 62) + 1), Error);
  }
}

TEST(Model, HashesValuesNotSpelling) {
  EXPECT_EQ(Model::parse("patricia(0.25)").stream_cell(100),
            Model::parse(" patricia ( 1/4 )").stream_cell(100));
  EXPECT_EQ(Model::parse("beta(10,80)").stream_cell(5), Model::parse("beta(1e1,80.0)").stream_cell(5));
  EXPECT_EQ(Model::parse("patricia(0.25)"), Model::parse("patricia(1/4)"));
}

TEST(Model, HasACellOfItsOwnForEverySize) {
  std::set<std::uint64_t> cells;
  std::size_t asked = 0;
  for (const char* text :
       {"bst", "catalan", "dst(0.25)", "dst(0.75)", "patricia(0.25)", "split(0.25)", "beta(1,11)",
        "beta(11,1)", "beta(1,1)", "beta_multinomial(1,1)", "patricia(0.2500000000000001)"})
    for (const Size n : {0u, 1u, 10u, 11u, 100u, 110u, 1000000u}) {
      cells.insert(Model::parse(text).stream_cell(n));
      ++asked;
    }
  EXPECT_EQ(cells.size(), asked);
}

TEST(Model, IsMadeOfNumbersAsOfTheirText) {
  struct Made {
    const ModelInfo* info;
    std::vector<double> numbers;
    const char* text;
  };
  for (const auto& [info, numbers, text] :
       {Made{&Bst::info(), {}, "bst"}, Made{&Beta::info(), {0.3, 80}, "beta(0.3,80)"},
        Made{&Patricia::info(), {1 / 4.35}, "patricia(0.2298850574712644)"},
        Made{&FixedSplit::info(), {0.29}, "split(0.29)"}, Made{&FixedSplit::info(), {1.0 / 3}, "split(1/3)"},
        Made{&find_model("trie"), {0.25}, "trie(0.25)"}}) {
    const Model made = Model::make(*info, numbers), parsed = Model::parse(text);
    EXPECT_EQ(made.text(), text);
    EXPECT_EQ(made, parsed);
    EXPECT_EQ(made.stream_cell(9), parsed.stream_cell(9)) << text;
  }
  EXPECT_THROW(Model::make(Dst::info(), std::vector<double>{1.5}), Error);
  EXPECT_THROW(Model::make(FixedSplit::info(), std::vector<double>{-1}), Error);
}

TEST(SplitCharacter, SaysHowDepthsGrow) {
  const auto exponent = [](const char* text) {
    return depth_exponent(Model::parse(text).character().fraction);
  };
  for (const char* text : {"bst", "beta(0.1,5)", "split(0.3)", "dst(0.3)", "complete", "aldous(-1)"})
    EXPECT_EQ(exponent(text), 0) << text;
  EXPECT_EQ(exponent("catalan"), 0.5);
  EXPECT_EQ(exponent("aldous(-1.5)"), 0.5);
  EXPECT_EQ(exponent("aldous(-1.75)"), 0.75);
  EXPECT_EQ(exponent("chain"), 1);
  EXPECT_EQ(exponent("ford(0)"), 0);
  EXPECT_EQ(exponent("ford(0.3)"), 0.3);
}

TEST(Models, AreListedOnceEachWithTheirSource) {
  std::set<std::string_view> names;
  for (const ModelInfo& info : models()) {
    EXPECT_TRUE(names.insert(info.name).second);
    EXPECT_FALSE(info.source.empty());
    EXPECT_FALSE(info.n_counts.empty());
  }
  for (const ModelInfo& info : models())
    if (info.name == "beta") {
      EXPECT_EQ(info.signature(), "beta(a,b)");
    }
}

// What the suites over every model are made of; file(PATH) has suites of its own.
TEST(TestedModels, AreAllModels) {
  std::set<std::string, std::less<>> tested{"file"};
  for (const auto& text : test::all_models()) tested.emplace(Model::parse(text).name());
  for (const auto& grown : test::grown_cases()) tested.emplace(Model::parse(grown.model).name());
  for (const ModelInfo& info : models()) EXPECT_TRUE(tested.contains(info.name)) << info.name;
}

}  // namespace
}  // namespace ramify
