// What `reproduce` and `run` leave to be read: report.html, tables claim by claim, and what becomes of them
// without gnuplot and beside committed verdicts.
#include <filesystem>
#include <string>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

namespace fs = std::filesystem;

const char* const two_models =
    "models = [\"bst\", \"catalan\"]\nn = [10, 1000]\nreplicates = 20\n"
    "statistics = [\"strahler\", \"nodes\", \"streams_mean_ratio\"]\n";

/// Landmarks, headings, alternative texts, links, ids, captions, groups of choices, no network
/// (check_page.py).
void expect_good_page(const fs::path& page) {
  const Ran ran = shell("python3 tests/cli/check_page.py " + page.string());
  EXPECT_EQ(ran.code, 0) << page << '\n' << ran.out << ran.err;
  EXPECT_LT(fs::file_size(page), 5'000'000u);
}

/// The rows of a table of verdicts that are of a claim.
std::string rows_of(const std::string& claim, const std::string& table) {
  std::istringstream lines(table);
  std::string rows;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(claim + ".")) rows += line + '\n';
  return rows;
}

TEST(ReproducePage, HasEveryClaimAskedForAndIsNamedLast) {
  const Scratch scratch;
  const fs::path out = scratch / "out";
  const Ran ran = ramify("reproduce --claim c3,C10 --out " + out.string());
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_TRUE(ran.err.ends_with("report:   " + out.string() + "/report.html\n")) << ran.err;
  expect_good_page(out / "report.html");
  const std::string page = read_file(out / "report.html");
  for (const char* part :
       {"<h2 id=\"C3\">", "<h3 id=\"C3.1\">", "<h2 id=\"C10\">", "<a href=\"#C10.1\">C10.1</a>",
        "<legend>verdict</legend>", "ramify reproduce --scale quick --claim C10\n",
        "ramify reproduce --scale quick --claim c3,C10\n"})
    EXPECT_TRUE(holds(page, part)) << part;
  EXPECT_FALSE(holds(page, "<h2 id=\"C4\">"));
  EXPECT_FALSE(holds(page, scratch.path().string())) << "a page says nothing of the machine";
  const std::string all = read_file(out / "verdicts.csv");
  for (const std::string claim : {"C3", "C10"}) {
    const std::string own = read_file(out / "claims" / (claim + ".csv"));
    EXPECT_EQ(rows_of(claim, own), rows_of(claim, all));
    EXPECT_EQ(count_lines(own), 1 + count_lines(rows_of(claim, all)));
  }
}

// A tiny config of C18, which is decided in some seconds: its trees, its pictures and its page.
TEST(ReproducePage, IsTheSameBytesEveryTimeAndOnAnyNumberOfThreads) {
  const Scratch scratch;
  fs::create_directories(scratch / "configs/quick");
  scratch.file("configs/quick/fill.toml",
               "claim = \"C18\"\nmodels = [\"bst\"]\nstatistics = [\"fill_level\"]\n"
               "n = { from = 10, factor = 4, count = 5 }\nreplicates = 50\n");
  const auto into = [&](const std::string& name, const std::string& threads) {
    const Ran ran = ramify("reproduce --claim C18 --configs " + (scratch / "configs").string() +
                           " --threads " + threads + " --out " + (scratch / name).string());
    EXPECT_EQ(ran.code, 0) << ran.err;
  };
  into("one", "1");
  for (const std::string threads : {"1", "2", "7"}) {
    into("other", threads);
    for (const char* file : {"report.html", "verdicts.csv", "claims/C18.csv", "claims/C18_points.csv",
                             "fill/summary.csv", "fill/report.html"}) {
      const std::string bytes = read_file(scratch / "one" / file);
      EXPECT_GT(bytes.size(), 100u) << file;
      EXPECT_TRUE(bytes == read_file(scratch / "other" / file)) << file << " on " << threads << " threads";
    }
  }
  const std::string page = read_file(scratch / "one/report.html");
  EXPECT_TRUE(holds(page, "<svg")) << "the picture of the claim";
  EXPECT_TRUE(holds(page, "<td class=\"short\">fill.toml</td>")) << "provenance";
  expect_good_page(scratch / "one/report.html");
}

TEST(RunPage, HasCellsPicturesTablesConfigAndCommand) {
  const Scratch scratch;
  const std::string config = scratch.file("two.toml", two_models);
  const Ran ran = ramify("run " + config + " --seed 7 --out " + (scratch / "o").string());
  ASSERT_EQ(ran.code, 0) << ran.err;
  const fs::path page = scratch / "o/two/report.html";
  EXPECT_TRUE(ran.err.ends_with("report:           " + page.string() + "\n")) << ran.err;
  expect_good_page(page);
  const std::string html = read_file(page);
  for (const char* part : {"<h1>Run of two.toml</h1>", ">Cells</h2>", ">Pictures</h2>", ">Tables</h2>",
                           ">Provenance</h2>", "<th scope=\"col\" class=\"number\">exact_mean</th>", "<svg",
                           "replicates = 20\n", "ramify run two.toml --seed 7\n"})
    EXPECT_TRUE(holds(html, part)) << part;
  EXPECT_FALSE(holds(html, scratch.path().string())) << "a page says nothing of the machine";
}

TEST(RunPage, OfAStoppedRunIsNotThere) {
  const Scratch scratch;
  const std::string config = scratch.file(
      "slow.toml",
      "models=[\"bst\"]\nn=[3000000]\nreplicates=10000\nstatistics=[\"strahler\"]\ngraft=false\n");
  const Ran ran = shell(std::string(RAMIFY_PROGRAM) + " run " + config + " --out " +
                        (scratch / "o").string() + " & run=$!; sleep 1; kill -INT $run; wait $run");
  EXPECT_EQ(ran.code, 130) << ran.err;
  EXPECT_FALSE(fs::exists(scratch / "o/slow.incomplete/report.html"));
}

TEST(Pages, WithoutGnuplotNameTheirPicturesAsMissingAndWarnOnce) {
  const Scratch scratch;
  const std::string one = scratch.file("one.toml", two_models), two = scratch.file("two.toml", two_models);
  const Ran ran = shell("PATH=" + (scratch / "nothing").string() + " " RAMIFY_PROGRAM " run " + one + " " +
                        two + " --out " + (scratch / "o").string());
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::string warning = "ramify: warning: pictures are missing: gnuplot is not installed";
  const auto first = ran.err.find(warning);
  ASSERT_NE(first, std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.find(warning, first + 1), std::string::npos) << ran.err;
  for (const char* name : {"one", "two"}) {
    const fs::path folder = scratch / "o" / name;
    EXPECT_TRUE(holds(read_file(folder / "report.html"),
                      "<p>Picture missing (Horton-Strahler number: order of the root (strahler)): gnuplot is "
                      "not installed.</p>"));
    EXPECT_TRUE(fs::exists(folder / "summary.csv"));
    EXPECT_TRUE(fs::exists(folder / "plots/strahler.gp")) << "the script draws them elsewhere";
    expect_good_page(folder / "report.html");
  }
}

/// Configs of no trees, and committed verdicts of C3 beside them.
std::string configs_with_verdicts(const Scratch& scratch, const std::string& verdicts) {
  fs::create_directories(scratch / "configs/quick");
  fs::create_directories(scratch / "results/reference/quick");
  scratch.file("results/reference/quick/verdicts.csv", verdicts);
  return " --configs " + (scratch / "configs").string() + " --out " + (scratch / "out").string();
}

TEST(Reproduce, EndsWith1WhereACommittedVerdictChangedOrIsMissing) {
  const Scratch scratch;
  const std::string committed =
      read_file(std::string(RAMIFY_SOURCE) + "/results/reference/quick/verdicts.csv");
  const Ran same = ramify("reproduce --claim C3" + configs_with_verdicts(scratch, committed));
  EXPECT_EQ(same.code, 0) << same.err;

  std::string changed = committed;
  const auto verdict = changed.find("reproduced", changed.find("\nC3.1,"));
  changed.replace(verdict, std::string("reproduced").size(), "refuted");
  const Ran other = ramify("reproduce --claim C3" + configs_with_verdicts(scratch, changed));
  EXPECT_EQ(other.code, 1);
  EXPECT_TRUE(holds(other.err, "ramify: a committed verdict changed: C3.1: reproduced, was refuted\n"))
      << other.err;

  std::string more = committed;
  const std::string row = rows_of("C3", committed).substr(0, rows_of("C3", committed).find('\n') + 1);
  more += "C3.9" + row.substr(row.find(','));
  const Ran missing = ramify("reproduce --claim C3" + configs_with_verdicts(scratch, more));
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(holds(missing.err, "a committed verdict changed: C3.9: no verdict on ")) << missing.err;
}

TEST(CheckPage, SeesWhatIsWrong) {
  const Scratch scratch;
  const Ran ran = shell("python3 tests/cli/check_page.py " +
                        scratch.file("bad.html",
                                     "<html><h1>a</h1><h3 id=\"x\">b</h3><p id=\"x\"><a href=\"#y\">c</a>"
                                     "<div role=\"img\"></div><script>d</script></p></html>"));
  EXPECT_EQ(ran.code, 1);
  for (const char* problem : {"no doctype", "h3 after h1", "an id comes twice: x", "nothing has the id 'y'",
                              "role img without a label", "no scripts"})
    EXPECT_TRUE(holds(ran.out, problem)) << problem << '\n' << ran.out;
}

}  // namespace
}  // namespace ramify::test
