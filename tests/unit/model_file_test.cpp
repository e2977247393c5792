// file(PATH): a split law of the user's own. Its refusals are in tests/cli/bad_input_test.cpp.
#include <filesystem>
#include <string>
#include <vector>

#include "support/split_table_file.hpp"
#include <gtest/gtest.h>

namespace ramify {
namespace {

using test::SplitTableFile;

const std::string small =
    "n,left,probability\n"
    "2,0,0.5\n2,1,0.5\n"
    "3,0,0.25\n3,2,0.75\n";

TEST(ModelOfFile, HoldsTheTable) {
  const SplitTableFile file(
      "# mine\nprobability,comment,n,left\r\n0.75,,3,2\n0,\"a, b\",3,1\n1/2,,2,1\n0.25,,3,0\n0.5,,2,0\n");
  const Model model = file.model();
  EXPECT_EQ(model.name(), "file");
  EXPECT_EQ(model.text(), "file(" + file.path().string() + ")");
  EXPECT_TRUE(model.parameters().empty());
  EXPECT_EQ(model.largest_size(), 3u);
  const auto& law = std::get<TabulatedSplit>(model.law());
  EXPECT_EQ(split_pmf(law, 1), (std::vector<double>{1}));
  EXPECT_EQ(split_pmf(law, 2), (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(split_pmf(law, 3), (std::vector<double>{0.25, 0, 0.75}));
  EXPECT_EQ(model, SplitTableFile(small).model());
}

TEST(ModelOfFile, MayNameSizeOneAndEndThere) {
  const SplitTableFile file("n,left,probability\n1,0,1\n"), longer("n,left,probability\n1,0,1\n2,1,1\n");
  EXPECT_EQ(file.model().largest_size(), 1u);
  EXPECT_EQ(longer.model(), SplitTableFile("n,left,probability\n2,1,1\n").model());
}

TEST(ModelOfFile, ScalesWhatIsNearlyOne) {
  const SplitTableFile file("n,left,probability\n2,0,0.3333333333\n2,1,0.6666666666\n");
  const auto pmf = split_pmf(std::get<TabulatedSplit>(file.model().law()), 2);
  EXPECT_EQ(pmf[0] + pmf[1], 1);
  EXPECT_NEAR(pmf[0], 1.0 / 3, 1e-15);
}

TEST(ModelOfFile, IsItsContentAndNotItsPath) {
  const SplitTableFile one(small), same(small), other(small + "4,1,1\n"),
      changed("n,left,probability\n2,0,0.5\n2,1,0.5\n3,0,0.75\n3,2,0.25\n");
  EXPECT_NE(one.model().text(), same.model().text());
  EXPECT_EQ(one.model(), same.model());
  EXPECT_EQ(one.model().stream_cell(3), same.model().stream_cell(3));
  for (const auto* file : {&other, &changed}) {
    EXPECT_FALSE(one.model() == file->model());
    EXPECT_NE(one.model().stream_cell(3), file->model().stream_cell(3));
    EXPECT_NE(one.model().stream_cell(2), file->model().stream_cell(2));
  }
  EXPECT_NE(one.model().stream_cell(2), one.model().stream_cell(3));
}

TEST(ModelOfFile, IsReadWhenItIsParsedAndNeverAgain) {
  const Model model = SplitTableFile(small).model();  // the file is gone by now
  EXPECT_EQ(split_pmf(std::get<TabulatedSplit>(model.law()), 3)[2], 0.75);
}

TEST(ModelOfFile, IgnoresWhiteSpaceRoundThePathAlone) {
  const SplitTableFile file(small);
  const Model model = Model::parse("  file (  " + file.path().string() + " ) ");
  EXPECT_EQ(model.text(), "file(" + file.path().string() + ")");
}

}  // namespace
}  // namespace ramify
