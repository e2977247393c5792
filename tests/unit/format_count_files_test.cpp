// Tables of counts as people publish them and programs write them, with the right answers by hand.
#include "support/fixtures.hpp"

#include "ramify/fit/ratio_datum.hpp"

namespace ramify {
namespace {

/// "12 4 1 / 1.5 3 10", counts and lengths; trees parted by "; ", or how they are refused.
std::string counts_of(std::string_view text) {
  std::string all;
  const std::string message = test::error_of([&] {
    for (const OrderCounts& orders : read_order_counts(SourceText(text, "f"))) {
      all += (all.empty() ? "" : "; ") + fmt::format("{}", fmt::join(orders.counts, " "));
      if (!orders.lengths.empty()) all += fmt::format(" / {}", fmt::join(orders.lengths, " "));
    }
  });
  return message.empty() ? all : "refused: " + message;
}

const std::vector<test::Fixture>& fixtures() {
  const char* const right = "1200 40 1 / 1.5 3 10";
  static const std::vector<test::Fixture> all{
      {"plain", "order,count,length\n1,1200,1.5\n2,40,3\n3,1,10\n", right},
      {"capitals and a unit in brackets", "Order,Count,Length (km)\n1,1200,1.5\n2,40,3\n3,1,10\n", right},
      {"Horton 1945", "Stream order,Number of streams,Mean length (mi)\n1,1200,1.5\n2,40,3\n3,1,10\n", right},
      {"semicolons", "order;count;length\n1;1200;1.5\n2;40;3\n3;1;10\n", right},
      {"tabs", "Order\tNumber\tLength_km\n1\t1200\t1.5\n2\t40\t3\n3\t1\t10\n", right},
      {"blanks", "order  n  length\n1      1200  1.5\n2      40  3\n3  1 10\n", right},
      {"a byte-order mark, Windows line ends",
       "\xEF\xBB\xBForder,count,length\r\n1,1200,1.5\r\n2,40,3\r\n3,1,10\r\n", right},
      {"old line ends", "order,count,length\r1,1200,1.5\r2,40,3\r3,1,10", right},
      {"Excel, English: quoted thousands", "order,count,length\n1,\"1,200\",1.5\n2,40,3\n3,1,10\n", right},
      {"Excel, German: decimal commas", "Order;Count;Length\n1;1200;1,5\n2;40;3,0\n3;1;10,0\n", right},
      {"Excel, German: points between thousands", "order;count;length\n1;1.200;1,5\n2;40;3,0\n3;1;10,0\n",
       right},
      {"Excel, French: blanks between thousands", "order;count;length\n1;1 200;1,5\n2;40;3,0\n3;1;10,0\n",
       right},
      {"Excel, French: blanks that do not break",
       "order;count;length\n1;1\xC2\xA0"
       "200;1,5\n2;40;3,0\n3;1;10,0\n",
       right},
      {"Excel, Swiss", "order;count;length\n1;1'200;1.5\n2;40;3\n3;1;10\n", right},
      {"low lines", "order,count,length\n1,1_200,1.5\n2,40,3\n3,1,10\n", right},
      {"R write.csv", "\"\",\"order\",\"count\",\"length\"\n\"1\",1,1200,1.5\n\"2\",2,40,3\n\"3\",3,1,10\n",
       right},
      {"R write.table", "\"order\" \"count\" \"length\"\n\"1\" 1 1200 1.5\n\"2\" 2 40 3\n\"3\" 3 1 10\n",
       right},
      {"pandas, floats", "order,count,length\n1.0,1200.0,1.5\n2.0,40.0,3.0\n3.0,1.0,10.0\n", right},
      {"R, large counts", "order,count\n1,1e+05\n2,4e+01\n3,1\n", "100000 40 1"},
      {"a total below", "order,count,length\n1,1200,1.5\n2,40,3\n3,1,10\nTotal,1241,\n", right},
      {"a total above", "order,count,length\nAll,1241,\n1,1200,1.5\n2,40,3\n3,1,10\n", right},
      {"rows from the highest order down", "order,count,length\n3,1,10\n2,40,3\n1,1200,1.5\n", right},
      {"columns that are not read", "basin,order,area,count,length\nx,1,7,1200,1.5\nx,2,8,40,3\nx,3,9,1,10\n",
       right},
      {"columns in another order", "length,count,order\n1.5,1200,1\n3,40,2\n10,1,3\n", right},
      {"leaf order 0", "order,count,leaf_order\n0,1200,0\n1,40,0\n2,1,0\n", "1200 40 1"},
      {"a length that is missing", "order,count,length\n1,1200,NA\n2,40,3\n3,1,\n", "1200 40 1 / nan 3 nan"},
      {"comments and empty lines",
       "# a river\n\norder,count,length\n1,1200,1.5\n# more\n2,40,3\n\n3,1,10\n,,\n", right},
      {"ramify measure -o",
       "tree,leaf_order,order,nodes,streams,mean_length\nx.swc,1,1,1200,1200,1.5\nx.swc,1,2,90,40,3\nx.swc,1,"
       "3,2,1,10\n",
       right},
      {"ramify measure -o, two trees",
       "tree,leaf_order,order,nodes,streams\na,1,1,6,6\na,1,2,2,2\na,1,3,1,1\nb,1,1,3,3\nb,1,2,2,1\n",
       "6 2 1; 3 1"},
      {"GRASS r.stream.stats", "Order,Stream num,Mean length\n1,1200,1.5\n2,40,3\n3,1,10\n", right},
      {"1.234 may be 1234", "order,count\n1,1.234\n2,40\n3,1\n",
       "refused: f:2:3: count = '1.234' (its mark may part thousands or decimals)"},
      {"1,234 may be 1.234", "order;count\n1;1,234\n2;40\n3;1\n",
       "refused: f:2:3: count = '1,234' (its mark may part"},
      {"1.234 beside decimal points is no count", "order,count,length\n1,1.234,1.5\n2,40,3\n3,1,9\n",
       "refused: f:2:3: count = '1.234'"},
      {"half a stream", "order,count\n1,1200.5\n2,40\n", "refused: not a whole number"},
      {"an order that is left out", "order,count\n1,1200\n3,1\n",
       "refused: f:3:1: order 3 (order 2 comes here"},
      {"an order twice", "order,count\n1,1200\n2,40\n2,30\n", "refused: f:4:1: order 2 (order 3 comes here"},
      {"counts that rise", "order,count\n1,12\n2,40\n", "refused: f:3:3: count 40"},
      {"no counts", "order,length\n1,2\n2,3\n", "refused: f:1:1: no column of counts"},
  };
  return all;
}

TEST(CountFiles, AreReadAsTheyAreWritten) {
  for (const test::Fixture& fixture : fixtures()) {
    const std::string answer = fixture.answer;
    test::expect_answer(fixture, counts_of(fixture.text));
    EXPECT_EQ(is_order_table(fixture.text), answer.find("no column") == std::string::npos) << fixture.writer;
  }
}

TEST(CountFiles, WhatIsNotReadIsSaid) {
  const auto warnings = [](std::string_view text) {
    const auto orders = read_order_counts(SourceText(text, "f"));
    return fmt::format("{}", fmt::join(orders.front().warnings, "\n"));
  };
  EXPECT_EQ(warnings("order,count\n1,6\n2,2\n3,1\n"), "");
  EXPECT_EQ(warnings("order,count,slope,Q\n1,6,1,1\n2,2,1,1\n3,1,1,1\ntotal,9,4,4\n"),
            "f: ignored: 1 row of totals, columns slope, Q");
  EXPECT_EQ(warnings("order,count\n1,6\n2,2\n3,1\ntotal,10\n"),
            "f: the total is 10, the counts of the orders sum to 9\nf: ignored: 1 row of totals");
}

TEST(CountFiles, WhatMeasureWritesFitReads) {
  const auto data = parse_ratio_data(
      "tree,leaf_order,order,nodes,streams,mean_length,mean_radius\na.swc,1,1,9,9,2,1\na.swc,1,2,5,3,4,2\na."
      "swc,1,3,2,1,8,4\n"
      "b.swc,1,1,8,8,2,1\nb.swc,1,2,3,2,4,2\nb.swc,1,3,1,1,8,4\n",
      "orders.csv");
  ASSERT_EQ(data.size(), 2u);
  EXPECT_EQ(data[0].name, "orders:a.swc");
  EXPECT_EQ(data[0].ratio, 3);
  EXPECT_EQ(data[0].sizes.at(0).n, 8u);
  EXPECT_NEAR(data[0].diameter_ratio->value, 2, 1e-12);
  EXPECT_EQ(data[1].ratio, 3);
}

}  // namespace
}  // namespace ramify
