#include <gtest/gtest.h>

#include "ramify/text/line_cursor.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify {
namespace {

TEST(SourceText, CountsLinesOfAnyKindAndCharacters) {
  const SourceText source(
      "\xEF\xBB\xBF"
      "a\nb\r\nc\rd\xC3\xA9x",
      "f");
  EXPECT_EQ(source.text().front(), 'a');
  const struct {
    char byte;
    std::size_t line, column;
  } places[] = {{'a', 1, 1}, {'b', 2, 1}, {'c', 3, 1}, {'d', 4, 1}, {'x', 4, 3}};
  for (const auto& [byte, line, column] : places) {
    const SourceLocation place = source.at(source.text().find(byte));
    EXPECT_EQ(place.line, line) << byte;
    EXPECT_EQ(place.column, column) << byte;
  }
}

TEST(SourceText, ErrorsAreOneLineWithTheirPlace) {
  const SourceText source("a\nbc", "f");
  EXPECT_STREQ(source.error(source.text().substr(3), "p\nq", "why", "remedy").what(),
               "f:2:2: p\\x0aq (why): remedy");
  EXPECT_EQ(excerpt(std::string(50, 'x')), std::string(40, 'x') + "...");
}

TEST(LineCursor, EndsLinesLikeSourceText) {
  LineCursor lines("a\n\r\nb\rc");
  std::string all;
  while (lines.next()) all += std::to_string(lines.number()) + std::string(lines.line()) + '|';
  EXPECT_EQ(all, "1a|2|3b|4c|");
  EXPECT_FALSE(LineCursor("").next());
}

}  // namespace
}  // namespace ramify
