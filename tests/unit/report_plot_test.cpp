#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "support/error_of.hpp"
#include "support/scratch.hpp"
#include <gtest/gtest.h>

#include "ramify/core/error.hpp"
#include "ramify/report/picture_file.hpp"
#include "ramify/report/plot.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

namespace fs = std::filesystem;

class PlotTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_); }

  PlotFiles draw(const Plot& plot, std::string_view stem) { return write_plot(plot, folder_, stem); }

  const test::Scratch scratch_;
  const fs::path folder_ = scratch_ / "ramify plot's";
};

Plot sample_plot() {
  Plot plot;
  plot.title = "Height";
  plot.subtitle = "2000 trees a size";
  plot.x_label = "n";
  plot.y_label = "E H";
  plot.log_x = true;
  plot.series = {{"bst", {{100, 12.5, 0.25}, {1000, 22, 0.5}, {1e6, 50, std::nan("")}}},
                 {"theorem", {}, {}, {{100, 12}, {1e6, 51}}},
                 {"both", {{100, 20, 1}, {1e6, 21, 1}}, {{100, 20.5}, {1e6, 20.5}}}};
  return plot;
}

bool gnuplot_is_there() {
  return std::system("command -v gnuplot >/dev/null 2>&1") == 0;
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST_F(PlotTest, ScriptHoldsTheDataAndTheErrorBars) {
  const std::string script = read_text_file(draw(sample_plot(), "height").script);
  EXPECT_TRUE(
      contains(script, "$series_1 << END\n100 12.5 12.25 12.75\n1000 22 21.5 22.5\n1000000 50 50 50\nEND\n"));
  EXPECT_TRUE(contains(script, "set logscale x\n"));
  EXPECT_FALSE(contains(script, "set logscale y\n"));
  EXPECT_TRUE(contains(script, "'10²' 1e2, '' 2e2 1,"));
  EXPECT_TRUE(contains(script, "keyentry with points lc rgb '#0072B2' lw 1.5 pt 7 ps 1 title 'bst'"));
  EXPECT_TRUE(contains(script, "keyentry with lines lc rgb '#D55E00' lw 2 dt (9,6) title 'theorem'"));
  EXPECT_TRUE(contains(script, "keyentry with linespoints lc rgb '#009E73' lw 2 pt 9 ps 1.1 title 'both'"));
  EXPECT_LT(script.find("$guide_2 using 1:2 with lines"),
            script.find("$series_1 using 1:2:3:4 with yerrorbars"));
  EXPECT_LT(script.find("$curve_3 using 1:2 with lines"),
            script.find("$series_1 using 1:2:3:4 with yerrorbars"));
  EXPECT_FALSE(contains(script, folder_.string()));  // it can be moved
}

TEST_F(PlotTest, OneLookIsOneModelWhateverItsPlace) {
  Plot plot = sample_plot();
  plot.series = {{"a", {{1, 1}}}, {"b", {{1, 2}}}, {"c", {{1, 3}}}};
  plot.series[0].look = 1;
  plot.series[2].look = 9;  // beyond the palette: the colour comes again, with another symbol
  const std::string script = read_text_file(draw(plot, "looks").script);
  EXPECT_TRUE(contains(script, "points lc rgb '#D55E00' lw 1.5 pt 5 ps 0.85 title 'a'"));
  EXPECT_TRUE(contains(script, "points lc rgb '#D55E00' lw 1.5 pt 5 ps 0.85 title 'b'"));
  EXPECT_TRUE(contains(script, "points lc rgb '#D55E00' lw 1.5 pt 9 ps 1.1 title 'c'"));
}

TEST_F(PlotTest, BarsStandOnZeroAndHaveRoomAtTheEnds) {
  Plot plot = sample_plot();
  plot.log_x = false;
  plot.whole_x = true;
  plot.series = {{"", {{2, 0.25}, {3, 0.75}}}};
  plot.series[0].mark = PlotSeries::Mark::bar;
  const PlotFiles files = draw(plot, "bars");
  const std::string script = read_text_file(files.script);
  EXPECT_TRUE(contains(script, "set xrange [1.44:3.56]\n"));
  EXPECT_TRUE(contains(script, "set yrange [0:0.795]\n"));
  EXPECT_TRUE(contains(script, "set xtics 1\n"));
  EXPECT_TRUE(contains(script, "$series_1 using 1:2:(0.9) with boxes"));
  if (gnuplot_is_there()) {
    EXPECT_EQ(files.status, PlotStatus::drawn) << files.message;
  }
}

TEST_F(PlotTest, SameBytesEachTime) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const PlotFiles first = draw(sample_plot(), "height");
  ASSERT_EQ(first.status, PlotStatus::drawn) << first.message;
  EXPECT_EQ(first.message, "");
  const std::string script = read_text_file(first.script), svg = read_text_file(first.svg);
  const std::string png = read_text_file(first.png);
  EXPECT_TRUE(contains(svg, "<svg"));
  EXPECT_TRUE(png.starts_with("\x89PNG\r\n\x1a\n"));
  ASSERT_EQ(draw(sample_plot(), "height").status, PlotStatus::drawn);
  EXPECT_EQ(read_text_file(first.script), script);
  EXPECT_EQ(read_text_file(first.svg), svg);
  EXPECT_EQ(read_text_file(first.png), png);
}

TEST_F(PlotTest, ScriptDrawsAgainByHand) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const PlotFiles files = draw(sample_plot(), "height");
  fs::remove(files.svg);
  fs::remove(files.png);
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  const int one = std::system("gnuplot -e \"formats='svg'\" height.gp 2>/dev/null");
  const bool svg = fs::exists("height.svg"), png = fs::exists("height.png");
  const int both = std::system("gnuplot height.gp 2>/dev/null");
  fs::current_path(before);
  EXPECT_EQ(one, 0);
  EXPECT_TRUE(svg && !png);
  EXPECT_EQ(both, 0);
  EXPECT_TRUE(fs::exists(files.png));
}

TEST_F(PlotTest, TextIsNeverACommand) {
  Plot plot = sample_plot();
  const fs::path harm = folder_ / "harm";
  plot.title = "it's \"R\" `touch " + harm.string() + "` \\ {a_1} $b @c %d <&>";
  plot.subtitle = "line\nbreak'";
  plot.series[0].label = "' ; system 'touch " + harm.string() + "'";
  plot.y_label = "\\";
  const PlotFiles files = draw(plot, "quotes");
  const std::string script = read_text_file(files.script);
  EXPECT_TRUE(contains(script, "'it’s \"R\" `touch "));
  EXPECT_TRUE(contains(script, "'line break’'"));
  if (!gnuplot_is_there()) return;
  ASSERT_EQ(files.status, PlotStatus::drawn) << files.message;
  EXPECT_FALSE(fs::exists(harm));
  EXPECT_TRUE(contains(read_text_file(files.svg), "\\ {a_1} $b @c %d &lt;&amp;></text>"));
}

TEST_F(PlotTest, PointsThatHaveNoPlaceAreLeftOut) {
  const double infinity = std::numeric_limits<double>::infinity();
  Plot plot = sample_plot();
  plot.log_y = true;
  plot.series = {{"a", {{0, 1}, {-1, 1}, {1, 0}, {std::nan(""), 1}, {1, infinity}, {2, 3, 4}, {20, 300}}},
                 {"empty"}};
  const PlotFiles files = draw(plot, "odd");
  const std::string script = read_text_file(files.script);
  // The bar of (2, 3 +- 4) would reach below 0.
  EXPECT_TRUE(contains(script, "$series_1 << END\n2 3 0.3 7\n20 300 300 300\nEND\n"));
  EXPECT_FALSE(contains(script, "$series_2"));
  if (gnuplot_is_there()) {
    EXPECT_EQ(files.status, PlotStatus::drawn) << files.message;
  }
}

TEST_F(PlotTest, OnePointIsAPicture) {
  for (const bool log : {false, true}) {
    Plot plot = sample_plot();
    plot.log_x = plot.log_y = log;
    plot.series = {{"", {{579, 5.03}}}};
    const PlotFiles files = draw(plot, "one");
    EXPECT_TRUE(contains(read_text_file(files.script), "unset key"));
    if (gnuplot_is_there()) {
      EXPECT_EQ(files.status, PlotStatus::drawn) << files.message;
    }
  }
}

TEST_F(PlotTest, NoPointsNoFiles) {
  Plot plot = sample_plot();
  plot.series = {{"a"}};
  EXPECT_EQ(draw(plot, "none").status, PlotStatus::no_points);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(PlotTest, WithoutGnuplotTheScriptStays) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  const PlotFiles files = draw(sample_plot(), "height");
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(files.status, PlotStatus::no_gnuplot);
  EXPECT_TRUE(fs::exists(files.script));
  EXPECT_TRUE(files.svg.empty());
}

TEST_F(PlotTest, GnuplotThatFailsLeavesNoPicture) {
  const fs::path fake = folder_ / "gnuplot";
  fs::create_directory(folder_ / "out");
  FILE* file = std::fopen(fake.c_str(), "w");
  std::fputs("#!/bin/sh\necho half > height.svg\necho; echo 'no memory left' >&2\nexit 3\n", file);
  std::fclose(file);
  fs::permissions(fake, fs::perms::owner_all);
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  const PlotFiles files = write_plot(sample_plot(), folder_ / "out", "height");
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(files.status, PlotStatus::failed);
  EXPECT_EQ(files.message, "no memory left");
  EXPECT_FALSE(fs::exists(folder_ / "out" / "height.svg"));
}

TEST_F(PlotTest, APictureFileIsTheOneFileAsked) {
  EXPECT_EQ(
      test::error_of([] { PictureFile("tree.pdf"); }),
      "--plot tree.pdf (pictures are SVG or PNG, as the name ends): take a name that ends in .svg or .png");
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  PictureFile(folder_ / "it's.svg").draw(sample_plot());
  EXPECT_TRUE(contains(read_text_file(folder_ / "it's.svg"), "<svg"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
  Plot empty = sample_plot();
  empty.series.clear();
  EXPECT_TRUE(contains(test::error_of([&] { PictureFile(folder_ / "none.svg").draw(empty); }),
                       "there is no value to draw"));
}

TEST_F(PlotTest, APictureFileWithoutGnuplotIsRefused) {
  const std::string before = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  const std::string error = test::error_of([&] { PictureFile("a.png").draw(sample_plot()); });
  ::setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(error, "--plot a.png (gnuplot is not installed): install gnuplot, or leave --plot out");
}

TEST_F(PlotTest, FolderThatIsNotThere) {
  EXPECT_THROW(write_plot(sample_plot(), folder_ / "absent", "height"), Error);
}

}  // namespace
}  // namespace ramify
