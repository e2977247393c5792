#include <string>
#include <vector>

#include "support/error_of.hpp"
#include "support/shape.hpp"
#include <gtest/gtest.h>

#include "ramify/tree/parenthesis_word.hpp"

namespace ramify {
namespace {

TEST(ParenthesisWord, RoundTripsEveryTreeToEightNodes) {
  for (std::size_t n = 0; n <= 8; ++n) {
    for (const auto& shape : test::all_shapes(n)) {
      const std::string word = test::to_word(shape);
      const Tree tree = from_parentheses(word);
      EXPECT_EQ(to_parentheses(tree), word);
      EXPECT_EQ(tree.size(), n);
      EXPECT_EQ(tree.node_count(), 2 * n + 1);
    }
  }
}

TEST(ParenthesisWord, ReadsAnyArity) {
  for (const char* word : {"(E)", "((E))", "(EEE)", "(E(EEEE)(E))"})
    EXPECT_EQ(to_parentheses(from_parentheses(word)), word);
  EXPECT_EQ(from_parentheses("(E(EEEE)(E))").size(), 3u);
}

TEST(ParenthesisWord, SkipsWhiteSpace) {
  EXPECT_EQ(from_parentheses(" ( E\n\t(E E)\r\n)\n"), from_parentheses("(E(EE))"));
}

struct WordRefusal {
  std::string text;
  std::string place;
  std::string why;
};

TEST(ParenthesisWord, RefusesWithTheColumn) {
  const std::vector<WordRefusal> refusals{
      {"", "word:1: ", "no tree at all"},
      {"  ", "word:1: ", "no tree at all"},
      {"(EX)", "word:3: ", "'X' is none of E, ( and )"},
      {"(Ee)", "word:3: ", "'e' is none of E, ( and )"},
      {"EE", "word:2: ", "more follows after the first tree"},
      {"(EE)(EE)", "word:5: ", "more follows after the first tree"},
      {"(EE) E", "word:6: ", "more follows after the first tree"},
      {"(EE))", "word:5: ", "a ')' without its '('"},
      {")", "word:1: ", "a ')' without its '('"},
      {"()", "word:2: ", "an internal node without children"},
      {"(E())", "word:4: ", "an internal node without children"},
      {"((EE)", "word:5: ", "1 '(' left open"},
      {"((", "word:2: ", "2 '(' left open"},
  };
  for (const auto& [text, place, why] : refusals) {
    const std::string message = test::error_of([&] { from_parentheses(text, "word"); });
    EXPECT_TRUE(message.starts_with(place)) << text << message;
    EXPECT_NE(message.find(why), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(ParenthesisWord, NeedsNoRecursion) {
  const std::size_t deep = 1000000;
  std::string word;
  for (std::size_t i = 0; i < deep; ++i) word += "(E";
  word += 'E';
  word.append(deep, ')');
  const Tree tree = from_parentheses(word);
  EXPECT_EQ(tree.size(), deep);
  EXPECT_EQ(to_parentheses(tree), word);
}

TEST(Tree, KnowsAWellFormedWord) {
  using Word = std::vector<std::uint32_t>;
  for (const Word& word : {Word{0}, Word{2, 0, 0}, Word{1, 0}, Word{3, 0, 2, 0, 0, 0}})
    EXPECT_TRUE(Tree::is_well_formed(word));
  for (const Word& word :
       {Word{}, Word{0, 0}, Word{2}, Word{2, 0}, Word{2, 0, 0, 0}, Word{0, 2, 0}, Word{1, 0, 0}})
    EXPECT_FALSE(Tree::is_well_formed(word));
}

}  // namespace
}  // namespace ramify
