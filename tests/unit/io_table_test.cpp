// Fields keep their types until a writer prints them.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ramify/io/csv_writer.hpp"
#include "ramify/io/json_writer.hpp"
#include "ramify/io/table.hpp"

namespace ramify {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::string> texts(const Row& row, std::size_t fields) {
  Table table(std::vector<std::string>(fields, "x"));
  table.add(row);
  std::vector<std::string> texts;
  for (const Field& field : table.row(0)) texts.push_back(to_text(field));
  return texts;
}

TEST(Table, PrintsNumbersAsTheirRowSays) {
  Row row;
  row.whole(std::uint64_t{18446744073709551615u}).whole(-3).whole(std::numeric_limits<std::int64_t>::min());
  row.summary(1.0 / 3).significant(1e6 / 3, 6).fixed(2.0 / 3, 3).exact(0.1).exact(infinity);
  EXPECT_EQ(texts(row, 8), (std::vector<std::string>{"18446744073709551615", "-3", "-9223372036854775808",
                                                     "0.3333333333", "333333", "0.667", "0.1", "inf"}));
}

TEST(Table, NotANumberAndNothingAreEmpty) {
  const double nan = std::nan("");
  EXPECT_EQ(texts(Row().nothing().text("").summary(nan).exact(nan).fixed(nan, 3), 5),
            std::vector<std::string>(5));
}

TEST(Table, NoSummaryIsANegativeZero) {
  EXPECT_EQ(texts(Row().summary(-0.0).exact(-0.0), 2), (std::vector<std::string>{"0", "-0"}));
}

TEST(Table, KeepsTypesAndOrder) {
  Table table({"model", "n"});
  table.add(Row().text("1").whole(2u));
  table.add(Row().nothing().exact(2));
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_FALSE(is_number(table.row(0)[0]));
  EXPECT_TRUE(is_number(table.row(0)[1]));
  EXPECT_FALSE(is_number(table.row(1)[0]));
  EXPECT_TRUE(is_number(table.row(1)[1]));
}

TEST(JsonWriter, TellsTextsFromNumbersFromNothing) {
  Table table({"model", "n", "mean", "exact \"mean\""});
  table.add(Row().text("12").whole(12u).summary(1.0 / 3).exact(0.1));
  table.add(Row().text("a\n\xff").nothing().summary(std::nan("")).exact(infinity));
  EXPECT_EQ(write_json(table),
            "[\n"
            "  {\"model\": \"12\", \"n\": 12, \"mean\": 0.3333333333, \"exact \\\"mean\\\"\": 0.1},\n"
            "  {\"model\": \"a\\n\xEF\xBF\xBD\", \"n\": null, \"mean\": null, \"exact \\\"mean\\\"\": null}\n"
            "]\n");
}

}  // namespace
}  // namespace ramify
