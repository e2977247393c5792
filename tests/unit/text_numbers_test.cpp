// Numbers and ids in all the ways in which programs write them, and what is remarked.
#include <gtest/gtest.h>

#include "ramify/text/number_style.hpp"
#include "ramify/text/remarks.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify {
namespace {

TEST(WholeNumber, IsReadHoweverItIsWritten) {
  for (const char* text : {"1", "01", "+1", "1.0", "1.", "1,0", "1e0", "1e+00", "10e-1", " 1 ", "0.1e1",
                           "1.000000000000000000e+00"})
    EXPECT_EQ(whole_number(text), "1") << text;
  EXPECT_EQ(whole_number("1e+05"), "100000");
  EXPECT_EQ(whole_number("7.12000001e+09"), "7120000010");
  EXPECT_EQ(whole_number("22000400023951"), "22000400023951");
  EXPECT_EQ(whole_number("-1.0"), "-1");
  EXPECT_EQ(whole_number("-0.0"), "0");
  EXPECT_EQ(whole_number("000"), "0");
}

TEST(WholeNumber, IsNothingElse) {
  for (const char* text :
       {"", "-", ".", "1.5", "1e-1", "1 0", "wb-1", "1a", "0x1", "1e", "e1", "1.0.0", "1e99", "--1", "nan"})
    EXPECT_EQ(whole_number(text), std::nullopt) << text;
}

TEST(IdKeys, AreNumbersByValueAndTextAsItIs) {
  IdKeys keys;
  EXPECT_EQ(keys("1"), keys("01"));
  EXPECT_EQ(keys("1"), keys("1.0"));
  EXPECT_EQ(keys("100000"), keys("1e+05"));
  EXPECT_EQ(keys("-1"), keys(" -1.0 "));
  EXPECT_NE(keys("1.5"), keys("1.50"));  // no whole number: numbering such as 1.5 and 1.50
  EXPECT_EQ(keys("wb-01"), "wb-01");
  EXPECT_EQ(keys(""), "");
}

TEST(IsMissing, KnowsWhatProgramsWrite) {
  for (const char* text :
       {"", " ", "NA", "na", "<NA>", "N/A", "#N/A", "NaN", "-nan", "None", "null", "NULL", "nil"})
    EXPECT_TRUE(is_missing(text)) << text;
  for (const char* text : {"0", "-1", "Na1", "N", "nothing"}) EXPECT_FALSE(is_missing(text)) << text;
}

NumberStyle style_of_fields(std::initializer_list<const char*> fields, bool comma_parts_fields = false) {
  NumberStyle style(comma_parts_fields);
  for (const char* field : fields) style.see(field);
  return style;
}

TEST(NumberStyle, LearnsTheDecimalMark) {
  const NumberStyle point = style_of_fields({"8.6"}), comma = style_of_fields({"8,6"});
  EXPECT_EQ(point.real("1,234"), 1234);
  EXPECT_EQ(comma.real("1,234"), 1.234);
  EXPECT_EQ(comma.real("1.234"), 1234);
  EXPECT_EQ(comma.count("1.234"), 1234u);
  EXPECT_EQ(point.count("1,234"), 1234u);
  EXPECT_EQ(point.count("1.234"), std::nullopt);
  EXPECT_TRUE(point.two_ways("1.234", true));
}

TEST(NumberStyle, ReadsWhatTellsItsMarkItself) {
  const NumberStyle unseen = style_of_fields({});
  EXPECT_EQ(unseen.real("1.234,5"), 1234.5);
  EXPECT_EQ(unseen.real("1,234.5"), 1234.5);
  EXPECT_EQ(unseen.real("0,123"), 0.123);
  EXPECT_EQ(unseen.real("1234,567"), 1234.567);
  EXPECT_EQ(unseen.real("1 234,5"), 1234.5);
  EXPECT_EQ(unseen.real("1'234.5"), 1234.5);
  EXPECT_EQ(unseen.real("-1,5e3"), -1500);
  EXPECT_EQ(unseen.real("1.234"), 1.234);
  EXPECT_EQ(unseen.count("12_345"), 12345u);
  EXPECT_EQ(unseen.count("12.0"), 12u);
  EXPECT_EQ(style_of_fields({}, true).count("1,234"), 1234u);
}

TEST(NumberStyle, RefusesWhatCanBeReadTwoWays) {
  const NumberStyle unseen = style_of_fields({}), both = style_of_fields({"8,6", "8.6"});
  EXPECT_TRUE(unseen.two_ways("1,234", false));
  EXPECT_EQ(unseen.real("1,234"), std::nullopt);
  EXPECT_EQ(unseen.count("1.234"), std::nullopt);
  EXPECT_EQ(unseen.count("1.000"), std::nullopt);
  EXPECT_EQ(both.real("1,234"), std::nullopt);
  EXPECT_EQ(both.real("1.234"), std::nullopt);
  EXPECT_EQ(both.real("8,6"), 8.6);
  for (const char* text : {"1.2.3", "1,2,3", "1.23,45.6", "1 2", "", "x", "1,,2", "1,234,56"})
    EXPECT_EQ(unseen.real(text), std::nullopt) << text;
}

TEST(Remarks, CountAndNameOnce) {
  Remarks remarks;
  EXPECT_TRUE(remarks.empty());
  remarks.ignore("row", "without a code");
  remarks.ignore("row", "without a code", 2);
  remarks.ignore("field", "after the seventh", 0);
  remarks.ignore_named("column", "branch.colour");
  remarks.ignore_named("column", "branch.colour");
  remarks.doubt("it is doubtful");
  remarks.doubt("it is doubtful");
  EXPECT_EQ(remarks.lines("f"),
            (std::vector<std::string>{"f: it is doubtful",
                                      "f: ignored: 3 rows without a code, column branch.colour"}));
}

}  // namespace
}  // namespace ramify
