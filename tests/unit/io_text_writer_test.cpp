#include <cmath>

#include <gtest/gtest.h>

#include "ramify/io/text_writer.hpp"

namespace ramify {
namespace {

/// Columns a and b, one row.
Table one_row(std::string_view a, std::string_view b) {
  Table table({"a", "b"});
  table.add(Row().texts({a, b}));
  return table;
}

TEST(TextWriter, AlignsNumbersRightAndTextLeft) {
  Table table({"claim", "estimate", "verdict"});
  table.add(Row().text("6").fixed(2.001, 3).text("reproduced"));
  table.add(Row().text("C20.2").whole(-10).text("no"));
  table.add(Row().text("C7").summary(std::nan("")).text("x"));
  EXPECT_EQ(write_text(table),
            "claim  estimate  verdict\n"
            "-----  --------  ----------\n"
            "6         2.001  reproduced\n"
            "C20.2       -10  no\n"
            "C7               x\n");
}

TEST(TextWriter, WrapsTheLastColumnAtSpaces) {
  Table table({"claim", "method"});
  table.add(Row().texts({"C6", "slope over nine sizes, with standard errors"}));
  EXPECT_EQ(write_text(table, 32),
            "claim  method\n"
            "-----  -------------------------\n"
            "C6     slope over nine sizes,\n"
            "       with standard errors\n");
}

TEST(TextWriter, CountsCharactersNotBytes) {
  EXPECT_EQ(write_text(one_row("±±±", "x")), "a    b\n---  -\n±±±  x\n");
}

TEST(TextWriter, LastColumnStaysReadableAndLongWordsWhole) {
  const std::string word(40, 'w');
  const std::string text = write_text(one_row(std::string(30, 'a'), word + " next"), 20);
  const std::string indent(32, ' ');
  EXPECT_NE(text.find(std::string(30, 'a') + "  " + word + "\n" + indent + "next\n"), std::string::npos);
}

TEST(TextWriter, HeaderAlone) {
  EXPECT_EQ(write_text(Table({"a", "b"})), "a  b\n-  -\n");
}

}  // namespace
}  // namespace ramify
