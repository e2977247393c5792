#include <gtest/gtest.h>

#include "ramify/report/verdict_table.hpp"

namespace ramify {
namespace {

using Rows = std::vector<std::vector<std::string>>;

TEST(TextTable, AlignsNumbersRightAndTextLeft) {
  const std::string table =
      text_table({"claim", "estimate", "verdict"},
                 Rows{{"C6", "2.001", "reproduced"}, {"C20.2", "-10", "no"}, {"C7", "", "x"}});
  EXPECT_EQ(table,
            "claim  estimate  verdict\n"
            "-----  --------  ----------\n"
            "C6        2.001  reproduced\n"
            "C20.2       -10  no\n"
            "C7               x\n");
}

TEST(TextTable, WrapsTheLastColumnAtSpaces) {
  const std::string table =
      text_table({"claim", "method"}, Rows{{"C6", "slope over nine sizes, with standard errors"}}, 32);
  EXPECT_EQ(table,
            "claim  method\n"
            "-----  -------------------------\n"
            "C6     slope over nine sizes,\n"
            "       with standard errors\n");
}

TEST(TextTable, CountsCharactersNotBytes) {
  EXPECT_EQ(text_table({"é", "b"}, Rows{{"±±", "x"}}), "é   b\n--  -\n±±  x\n");
}

TEST(TextTable, LastColumnStaysReadableAndLongWordsWhole) {
  const std::string word(40, 'w');
  const std::string table = text_table({"a", "b"}, Rows{{std::string(30, 'a'), word + " next"}}, 20);
  const std::string indent(32, ' ');
  EXPECT_NE(table.find(std::string(30, 'a') + "  " + word + "\n" + indent + "next\n"), std::string::npos);
}

TEST(TextTable, HeaderAlone) {
  EXPECT_EQ(text_table({"a", "b"}, {}), "a  b\n-  -\n");
}

}  // namespace
}  // namespace ramify
