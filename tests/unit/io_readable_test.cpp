// The table for a person: fewer digits, no empty columns; the table itself stays what it is.
#include <limits>

#include <gtest/gtest.h>

#include "ramify/io/csv_writer.hpp"
#include "ramify/io/readable.hpp"

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(Readable, HasNoEmptyColumnsAndNoMoreDigitsThanAreRead) {
  Table table({"name", "nothing", "nan", "text", "mean", "exact", "fixed", "count"});
  table.add(Row()
                .text("a")
                .nothing()
                .summary(none)
                .text("")
                .summary(1.23456789)
                .exact(1.0 / 3)
                .fixed(2, 3)
                .whole(7u));
  table.add(Row().text("b").nothing().summary(none).text("").summary(none).exact(0.5).fixed(1, 3).whole(-1));
  EXPECT_EQ(write_csv(readable(table)),
            "name,mean,exact,fixed,count\na,1.2346,0.3333333333,2.000,7\nb,,0.5,1.000,-1\n");
  EXPECT_EQ(write_csv(table).substr(0, 17), "name,nothing,nan,");
}

TEST(Readable, OfNoRowsIsTheHeader) {
  EXPECT_EQ(readable(Table({"a", "b"})).columns().size(), 2u);
}

}  // namespace
}  // namespace ramify
