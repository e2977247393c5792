// ramify draw: files that other programs open, the tree of sample, one line for whatever cannot be drawn.
#include <chrono>
#include <set>
#include <thread>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

TEST(Draw, WritesWhatTheNameSays) {
  const Scratch scratch;
  const std::string sapling = "draw --tree data/examples/sapling.newick -o ";
  for (const char* style : {" --style dendrogram", " --style upright"}) {
    ASSERT_EQ(ramify(sapling + (scratch / "a.svg").string() + style).code, 0);
    ASSERT_EQ(ramify(sapling + (scratch / "a.png").string() + style).code, 0);
    EXPECT_NE(read_file(scratch / "a.svg").find("</svg>"), std::string::npos);
    EXPECT_TRUE(read_file(scratch / "a.png").starts_with("\x89PNG"));
  }
}

TEST(Draw, TheSameTreeIsTheSameBytes) {
  const Scratch scratch;
  const std::string bst = "draw --model bst --n 100 --seed 7 --replicate 3 -o ";
  ASSERT_EQ(ramify(bst + (scratch / "a.svg").string()).code, 0);
  ASSERT_EQ(ramify(bst + (scratch / "b.svg").string()).code, 0);
  EXPECT_EQ(read_file(scratch / "a.svg"), read_file(scratch / "b.svg"));
}

// The tree that sample writes, read back, is the tree that draw grows: but for the title the drawings are
// one.
TEST(Draw, GrowsTheTreeOfSample) {
  const Scratch scratch;
  const std::string which = "--model 'beta(2,3)' --n 60 --seed 5 --replicate 2 ";
  ASSERT_EQ(ramify("draw " + which + "--same-lengths -o " + (scratch / "a.svg").string()).code, 0);
  const std::string file = scratch.file("t.txt", ramify("sample " + which + "--format parens").out);
  ASSERT_EQ(ramify("draw --same-lengths --tree " + file + " -o " + (scratch / "b.svg").string()).code, 0);
  const auto branches = [](const std::string& svg) {
    std::string paths;
    std::istringstream lines(svg);
    for (std::string line; std::getline(lines, line);)
      if (line.find("stroke-width") != std::string::npos) paths += line + '\n';
    return paths;
  };
  EXPECT_GT(branches(read_file(scratch / "a.svg")).size(), 1000u);
  EXPECT_EQ(branches(read_file(scratch / "a.svg")), branches(read_file(scratch / "b.svg")));
}

// A file of points has a form of its own; any other refuses to say what points up.
TEST(Draw, PointsStandWhereTheyWereMeasured) {
  const Scratch scratch;
  const std::string sapling = "draw --tree data/examples/sapling.swc --style lines -o ";
  ASSERT_EQ(ramify(sapling + (scratch / "a.svg").string()).code, 0);
  ASSERT_EQ(ramify(sapling + (scratch / "b.svg").string() + " --up z").code, 0);
  EXPECT_NE(read_file(scratch / "a.svg"), read_file(scratch / "b.svg"));
  for (const std::string wrong :
       {"--tree data/examples/sapling.newick --style lines --up z", "--model bst --n 9 --style lines --up z",
        "--tree data/examples/sapling.swc --up z", "--tree data/examples/sapling.swc --style lines --up x"}) {
    const Ran ran = ramify("draw " + wrong + " -o " + (scratch / "c.svg").string());
    EXPECT_EQ(ran.code, 2) << wrong;
    EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
    EXPECT_FALSE(std::filesystem::exists(scratch / "c.svg"));
  }
}

// A node is a line: of measured trees the tips too, of grown ones internal nodes alone.
TEST(Draw, TipsOfMeasuredTreesAreBranches) {
  const Scratch scratch;
  const auto lines = [&](const std::string& tree) {
    const std::string file = (scratch / "a.svg").string();
    EXPECT_EQ(ramify("draw " + tree + " --style lines -o " + file).code, 0);
    const std::string svg = read_file(file);
    std::size_t count = 0;
    for (std::size_t at = svg.find(" L "); at != std::string::npos; at = svg.find(" L ", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(lines("--tree data/examples/sapling.newick"), 15u);  // 8 tips
  EXPECT_EQ(lines("--tree data/examples/sapling.swc"), 31u);     // points
  EXPECT_EQ(lines("--model bst --n 100"), 100u);
}

TEST(Draw, EveryFormatIsWhatItsNameSays) {
  const Scratch scratch;
  const std::string tree = "draw --preset ginkgo -o ";
  for (const auto& [name, begins] :
       {std::pair("a.svg", "<?xml"), std::pair("a.pdf", "%PDF-"), std::pair("a.ps", "%!PS-Adobe")}) {
    ASSERT_EQ(ramify(tree + (scratch / name).string()).code, 0);
    EXPECT_TRUE(read_file(scratch / name).starts_with(begins)) << name;
  }
}

// No clock in a picture, whatever its format; over a second, for dates are written to the second.
TEST(Draw, TheSamePresetIsTheSameBytes) {
  const Scratch scratch;
  for (const std::string ending : {".svg", ".pdf", ".ps", ".png"}) {
    ASSERT_EQ(ramify("draw --preset lightning -o " + (scratch / ("a" + ending)).string()).code, 0);
    if (ending == ".pdf" || ending == ".ps") std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    ASSERT_EQ(ramify("draw --preset lightning -o " + (scratch / ("b" + ending)).string()).code, 0);
    EXPECT_EQ(read_file(scratch / ("a" + ending)), read_file(scratch / ("b" + ending))) << ending;
  }
}

TEST(Draw, OptionsChangeThePicture) {
  const Scratch scratch;
  std::set<std::string> pictures;
  for (const std::string options : {"", "--n 300", "--seed 2", "--replicate 1", "--view top", "--style bars",
                                    "--style lines", "--color-by order", "--sheet", "--side 500"}) {
    const std::string file = (scratch / "a.svg").string();
    ASSERT_EQ(ramify("draw --preset space_orders " + options + " -o " + file).code, 0);
    pictures.insert(read_file(file));
  }
  EXPECT_EQ(pictures.size(), 10u);
}

// One row of each: the complete tree of 12 levels, whose squares have the first one's area at every level.
TEST(Draw, TablesMeasureTheForm) {
  const Ran orders = ramify("draw --preset pythagoras --table orders");
  EXPECT_EQ(orders.code, 0);
  EXPECT_EQ(count_lines(orders.out), 1u + 12);
  EXPECT_NE(orders.out.find("\n1,complete,4095,1996,0,1,13,1,1,1,2,2\n"), std::string::npos) << orders.out;
  const Ran summary = ramify("draw --preset pythagoras --table summary");
  // 12 levels of sides 2/sqrt(2)^k: the ratio from order to order is sqrt(2).
  EXPECT_NE(summary.out.find(",1.414213562,1.414213562\n"), std::string::npos) << summary.out;
}

TEST(Draw, MeasuredTreesHaveTheirOwnForm) {
  const Scratch scratch;
  for (const char* file : {"sapling.swc", "sapling.newick", "sapling.mtg"})
    EXPECT_EQ(ramify(std::string("draw --style branches --tree data/examples/") + file + " -o " +
                     (scratch / "a.svg").string())
                  .code,
              0)
        << file;
  EXPECT_EQ(
      ramify("draw --style branches --sheet --model \"kary(3)\" --n 5 -o " + (scratch / "b.svg").string())
          .code,
      0);
}

// Some seconds: it draws every preset, as many are shown in docs/gallery.md.
TEST(Draw, TheGalleryIsWholeAndThatOfTheDocumentation) {
  const Scratch scratch;
  const auto folder = scratch / "gallery";
  ASSERT_EQ(ramify("draw --gallery " + folder.string()).code, 0);
  EXPECT_FALSE(std::filesystem::exists(scratch / "gallery.incomplete"));
  const std::string page = read_file(folder / "index.html");
  std::size_t presets = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(RAMIFY_SOURCE) / "configs/draw")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = entry.path().stem().string();
    ++presets;
    EXPECT_TRUE(std::filesystem::exists(folder / (name + ".svg"))) << name;
    EXPECT_TRUE(std::filesystem::exists(folder / "thumbnails" / (name + ".png"))) << name;
    EXPECT_NE(page.find("ramify draw --preset " + name + " -o"), std::string::npos) << name;
  }
  EXPECT_GE(presets, 40u);
  const auto docs = std::filesystem::path(RAMIFY_SOURCE) / "docs";
  EXPECT_EQ(read_file(folder / "gallery.md"), read_file(docs / "gallery.md"));
  EXPECT_LT(std::filesystem::file_size(docs / "contact-sheet.png"), 2'000'000u);
}

struct Refusal {
  std::string arguments, message;
  friend std::ostream& operator<<(std::ostream& out, const Refusal& refusal) {
    return out << refusal.arguments;
  }
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, InOneLineWithoutAFile) {
  const Scratch scratch;
  scratch.file("two.nwk", "(a,b);\n(c,d);\n");
  scratch.file("nan.nwk", "(a:1,b);\n");
  scratch.file("negative.nwk", "(a:1,b:-2);\n");
  scratch.file("radii.csv", "id,parent,length,radius\n1,,1,1\n2,1,1,\n3,1,1,1\n");
  std::filesystem::create_directories(scratch / "presets" / "draw");
  const auto preset = [&](const std::string& name, const std::string& radius, const std::string& length) {
    scratch.file("presets/draw/" + name + ".toml",
                 "title = \"a\"\nsource = \"b\"\nmodel = \"bst\"\nn = 20\n" + radius + '\n' + length +
                     "\ndeviation = { rule = \"murray\" }\n");
  };
  const std::string one = "length = { rule = \"constant\", c = 1 }";
  preset("wrong", "radius = { rule = \"constnt\", c = 1 }", one);
  preset("angle", "radius = { rule = \"leaves_power\", c = 1, exponent = 1 }", one);
  preset("zero", "radius = { rule = \"constant\", c = 0 }",
         "length = { rule = \"radius_power\", c = 1, exponent = -1 }");
  const auto files = [&] {
    return std::distance(std::filesystem::directory_iterator(scratch.path()),
                         std::filesystem::directory_iterator());
  };
  const auto before = files();
  const Ran ran =
      shell("cd " + scratch.path().string() + " && " + RAMIFY_PROGRAM + " draw " + GetParam().arguments);
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(count_lines(ran.err), 1u) << ran.err;
  EXPECT_NE(ran.err.find(GetParam().message), std::string::npos) << ran.err;
  EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    All, Refused,
    testing::Values(
        Refusal{"--model bst --n 10 -o a.gif", "take a name that ends in .svg, .pdf, .ps or .png"},
        Refusal{"--model bst --n 10 -o a", "take a name that ends in .svg, .pdf, .ps or .png"},
        Refusal{"--model bst --n 10", "--output is required"},
        Refusal{"-o a.svg", "neither --tree nor --model"},
        Refusal{"--tree two.nwk --model bst --n 3 -o a.svg", "--tree and --model"},
        Refusal{"--model bst -o a.svg", "add --n"},
        Refusal{"--model bst --n 1e6 -o a.svg", "take a name that ends in .png"},
        Refusal{"--model bst --n 1e9 -o a.svg", "take a smaller tree"},
        Refusal{"--model bst --n 1e9 -o a.png", "take a smaller tree"},
        Refusal{"--model bst --n 10 --style star -o a.svg", "take dendrogram or upright"},
        Refusal{"--model bst --n 10 --leaf-order 2 -o a.svg", "it is 0 or 1"},
        Refusal{"--tree two.nwk -o a.svg", "add --which K, K from 1 to 2"},
        Refusal{"--tree two.nwk --which 3 -o a.svg", "take a number from 1 to 2"},
        Refusal{"--tree negative.nwk -o a.svg", "has the length -2"},
        Refusal{"--tree none.nwk -o a.svg", "none.nwk"},
        Refusal{"--model bst --n 10 -o nowhere/a.svg", "create its folder"},
        Refusal{"--model bst --n 1e6 --style branches -o a.pdf", "take a name that ends in .png"},
        Refusal{"--preset aple_life -o a.svg", "did you mean apple_life"},
        Refusal{"--preset apple_life", "--output is required"},
        Refusal{"--preset apple_life --model bst --n 3 -o a.svg", "--model and --preset"},
        Refusal{"--preset apple_life --style upright -o a.svg", "take lines, bars or branches"},
        Refusal{"--preset apple_life --view frnt -o a.svg", "did you mean front"},
        Refusal{"--preset apple_life --sheet -o a.svg", "leave --sheet out"},
        Refusal{"--preset beta_large --n 1e6 -o a.svg", "take a name that ends in .png"},
        Refusal{"--preset apple_life --configs . -o a.svg", "no presets in './draw'"},
        Refusal{"--preset wrong --configs presets -o a.svg", "presets/draw/wrong.toml:5:19: no rule"},
        Refusal{"--preset angle --configs presets -o a.svg",
                "presets/draw/angle.toml: Murray's angle of radii"},
        Refusal{"--preset zero --configs presets -o a.svg", "change the constants of its rule"},
        Refusal{"--model bst --n 10 --view top -o a.svg", "add --style branches"},
        Refusal{"--model bst --n 10 --style branches --side 3 -o a.svg", "it lies from 50"},
        Refusal{"--tree radii.csv --style branches -o a.svg", "has the radius nan"},
        Refusal{"--tree negative.nwk --style branches -o a.svg", "has the length -2"},
        Refusal{"--gallery two.nwk", "it exists"},
        Refusal{"--gallery new --configs presets", "presets/draw/angle.toml"}),
    [](const auto& refusal) { return name_of({std::to_string(refusal.index)}); });

}  // namespace
}  // namespace ramify::test
