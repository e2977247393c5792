// Every table and every tree of data/ is read, says where it comes from, and has the ratios that were
// published.
#include <filesystem>

#include "support/tree_files.hpp"
#include <gtest/gtest.h>

#include "ramify/family/observed_bi_orders.hpp"
#include "ramify/fit/ratio_datum.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/statistic/order_ratios.hpp"
#include "ramify/text/csv_reader.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

const std::filesystem::path folder = std::filesystem::path(RAMIFY_SOURCE_DIR) / "data";

TEST(Data, EveryTableIsReadAndSaysWhereItComesFrom) {
  std::size_t tables = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".csv") continue;
    SCOPED_TRACE(entry.path());
    const std::string text = read_text_file(entry.path());
    EXPECT_TRUE(text.starts_with("# "));
    const std::string head = text.substr(0, text.find("\n", text.rfind("\n# ") + 1));
    EXPECT_TRUE(head.find("1996") != std::string::npos || head.find("Source: ") != std::string::npos);
    const std::string name = entry.path().stem();
    if (name == "ramification_bst") {
      EXPECT_NO_THROW(Model::parse("ramification(" + entry.path().string() + ")"));
    } else if (name == "coronary_connectivity") {
      EXPECT_EQ(CsvData::read(entry.path()).rows(), 137u);
    } else if (is_bi_order_table(text)) {
      EXPECT_EQ(ObservedBiOrders::of_table(CsvData::parse(text, name)).tree_orders().size(), 1u);
    } else {
      EXPECT_NE(head.find("confidence: "), std::string::npos);
      EXPECT_NE(head.find("leaf_order"), std::string::npos);
      EXPECT_FALSE(read_ratio_data(entry.path()).empty());
    }
    ++tables;
  }
  EXPECT_EQ(tables, 14u);
}

TEST(Data, RegressionsAreThosePublished) {
  const struct {
    const char* file;
    double regression, last_digit;
  } published[] = {{"coronary_rca.csv", 3.50, 0.01},     {"coronary_lad.csv", 3.51, 0.01},
                   {"coronary_lcx.csv", 3.57, 0.01},     {"pulmonary_artery.csv", 3.354, 0.001},
                   {"pulmonary_vein.csv", 3.333, 0.001}, {"airway_ct.csv", 2.454, 0.001}};
  for (const auto& [file, regression, last_digit] : published) {
    const std::string text = read_text_file(folder / file);
    const OrderCounts counts = read_order_counts(SourceText(text, file)).front();
    EXPECT_NEAR(order_ratios(counts.counts).regression, regression, 0.51 * last_digit) << file;
  }
}

TEST(Data, EveryExampleIsRead) {
  std::size_t trees = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "examples"))
    trees += test::trees_of(read_tree_file(entry.path())).size();
  EXPECT_EQ(trees, 7u);
}

}  // namespace
}  // namespace ramify
