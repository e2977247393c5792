#include "support/error_of.hpp"
#include <gtest/gtest.h>

#include "ramify/io/csv_writer.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {
namespace {

using test::error_of;

std::string csv_error(std::string_view text) {
  return test::error_of([&] { CsvData::parse(text, "t.csv"); });
}

TEST(CsvWriter, QuotesOnlyWhereNeeded) {
  Table table({"model", "note"});
  table.add(Row().texts({"beta(10,80)", "plain text"}));
  table.add(Row().texts({"a \"b\"", "two\nlines"}));
  table.add(Row().texts({"", "#"}));
  EXPECT_EQ(write_csv(table),
            "model,note\n\"beta(10,80)\",plain text\n\"a \"\"b\"\"\",\"two\nlines\"\n,\"#\"\n");
}

TEST(Csv, EveryFieldReadsBackAsWritten) {
  const std::vector<std::string> awkward{"",     "#",  "a,b",   "\"", "\"\"",  "\n",
                                         "\r\n", "\r", " pad ", "é",  ",\"\n#"};
  for (const auto& first : awkward) {
    for (const auto& second : awkward) {
      Table table({"#x", "y"});
      table.add(Row().texts({first, second}));
      const CsvData data = CsvData::parse(write_csv(table), "t.csv");
      ASSERT_EQ(data.rows(), 1u);
      EXPECT_EQ(data.at(0, "#x"), first);
      EXPECT_EQ(data.at(0, "y"), second);
    }
    Table narrow({"x"});
    narrow.add(Row().text(first));
    const CsvData data = CsvData::parse(write_csv(narrow), "t.csv");
    ASSERT_EQ(data.rows(), 1u);
    EXPECT_EQ(data.at(0, "x"), first);
  }
}

TEST(CsvReader, AcceptsCommentsBomCrlfAndMissingLastNewline) {
  const CsvData data =
      CsvData::parse("\xEF\xBB\xBF# Kruszewski, table 3\r\n#\r\n\r\na,b\r\n1,\"x\r\ny\"\r\n#3,4", "t.csv");
  EXPECT_EQ(data.header(), (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(data.rows(), 2u);
  EXPECT_EQ(data.at(0, "b"), "x\r\ny");
  EXPECT_EQ(data.at(1, "a"), "#3");  // after the header a # is data
  EXPECT_EQ(data.where(0).line, 5u);
  EXPECT_EQ(data.where(1).line, 7u);
  EXPECT_EQ(data.column("b"), 1u);
  EXPECT_EQ(data.column("c"), std::nullopt);
}

TEST(CsvReader, PlacesCountCharactersNotBytes) {
  const CsvData data = CsvData::parse("name,count\nçédille,12\n", "t.csv");
  const SourceLocation place = data.where(0, "count");
  EXPECT_EQ(to_prefix(place), "t.csv:2:9: ");
}

TEST(CsvReader, RefusesWithThePlace) {
  EXPECT_EQ(
      csv_error(""),
      "t.csv: no header (a table starts with a line that names its columns): add one, such as order,count");
  EXPECT_TRUE(csv_error("# only\n# comments\n").starts_with("t.csv: no header ("));
  EXPECT_TRUE(csv_error("a,b,a\n").starts_with("t.csv:1:5: column 'a' twice ("));
  EXPECT_TRUE(csv_error("a,b\n1,2\n3\n").starts_with("t.csv:3:1: a row of 1 field(s) (the header has 2): "));
  EXPECT_TRUE(csv_error("a,b\n1,2,3\n").starts_with("t.csv:2:5: a row of 3 field(s) (the header has 2): "));
  EXPECT_TRUE(csv_error("a,b\n1,2\n\n3,\"x\ny\n").starts_with("t.csv:4:3: a quote that is never closed ("));
  EXPECT_TRUE(csv_error("a,b\n1,x\"y\"\n").starts_with("t.csv:2:4: a quote inside a field ("));
  EXPECT_TRUE(csv_error("a,b\n\"1\"x,2\n").starts_with("t.csv:2:4: text after a closing quote ("));
  EXPECT_TRUE(csv_error("a,b\r1,2\r").starts_with("t.csv:1:4: a carriage return alone ("));
}

TEST(CsvReader, TypedFields) {
  const CsvData data =
      CsvData::parse("name,n,ratio\napple , 1e3 , 1/4 \n,,\noak,-1,inf\nelm,2.5,x\n", "t.csv");
  EXPECT_EQ(data.text(0, "name"), "apple");
  EXPECT_EQ(data.count(0, "n"), 1000u);
  EXPECT_EQ(data.real(0, "ratio"), 0.25);
  EXPECT_EQ(data.optional_count(1, "n"), std::nullopt);
  EXPECT_EQ(data.optional_real(1, "ratio"), std::nullopt);
  EXPECT_EQ(error_of([&] { data.text(1, "name"); }),
            "t.csv:3:1: name = '' (it must not be empty): fill it in");
  EXPECT_EQ(error_of([&] { data.count(1, "n"); }),
            "t.csv:3:2: n = '' (a whole number is needed here): fill it in");
  EXPECT_TRUE(error_of([&] { data.real(1, "ratio"); }).starts_with("t.csv:3:3: ratio = '' ("));
  EXPECT_TRUE(
      error_of([&] { data.optional_count(2, "n"); }).starts_with("t.csv:4:5: n = '-1' (not a whole number"));
  EXPECT_TRUE(error_of([&] {
                data.optional_real(2, "ratio");
              }).starts_with("t.csv:4:8: ratio = 'inf' (not a finite"));
  EXPECT_TRUE(error_of([&] { data.count(3, "n"); }).starts_with("t.csv:5:5: n = '2.5' ("));
  EXPECT_EQ(error_of([&] { data.at(0, "ration"); }),
            "t.csv: no column 'ration' (the columns are name, n, ratio): did you mean ratio? add or rename a "
            "column");
}

TEST(CsvReader, FileThatIsNotThere) {
  EXPECT_EQ(error_of([] { CsvData::read("/no/such/file.csv"); }),
            "cannot read '/no/such/file.csv' (No such file or directory): check the path");
  EXPECT_EQ(error_of([] { CsvData::read("/"); }),
            "cannot read '/' (Is a directory): give a file that you may read");
}

}  // namespace
}  // namespace ramify
