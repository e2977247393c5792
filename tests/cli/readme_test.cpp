// Every command of the program that README.md and docs/ show is run, as it stands.
#include <algorithm>
#include <regex>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

#ifdef RAMIFY_HAS_MPI
constexpr bool has_mpi = true;
#else
constexpr bool has_mpi = false;
#endif

bool starts_ramify_by_mpirun(const std::string& line) {
  return line.starts_with("    mpirun ") && line.find(" ramify ") != std::string::npos;
}

/// The commands that a page shows.
std::vector<std::string> commands_of(const std::string& page) {
  std::vector<std::string> found;
  std::istringstream lines(read_file(std::filesystem::path(RAMIFY_SOURCE) / page));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("    ramify ") || (has_mpi && starts_ramify_by_mpirun(line)))
      found.push_back(line.substr(4));
  return found;
}

/// A folder that has what the pages assume: the project's data and configs, and the reader's own tables.
void furnish(const Scratch& scratch) {
  for (const char* name : {"data", "configs"})
    std::filesystem::create_directory_symlink(std::filesystem::path(RAMIFY_SOURCE) / name, scratch / name);
  scratch.file("mine.csv", "order,count\n1,279\n2,52\n3,7\n4,1\n");
  scratch.file("my_tree.txt", "((E(E(EE)))((E(EE))((E(EE))((EE)(E(E(EE)))))))\n");
  scratch.file("splits.csv", "n,left,probability\n2,0,0.5\n2,1,0.5\n3,0,0.25\n3,1,0.5\n3,2,0.25\n");
}

/// README.md and the pages of docs/ that show a command, from the project's folder.
std::vector<std::string> pages_with_commands() {
  const std::filesystem::path project(RAMIFY_SOURCE);
  std::vector<std::string> pages{"README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(project / "docs")) {
    const std::string page = std::filesystem::relative(entry.path(), project).string();
    if (entry.path().extension() == ".md" && !commands_of(page).empty()) pages.push_back(page);
  }
  std::sort(pages.begin() + 1, pages.end());
  return pages;
}

/// The commands of a page that no page before it shows: some fit or run for seconds.
std::vector<std::string> new_commands(const std::string& page) {
  std::vector<std::string> found = commands_of(page);
  for (const auto& before : pages_with_commands()) {
    if (before == page) break;
    for (const auto& command : commands_of(before)) std::erase(found, command);
  }
  return found;
}

class Page : public testing::TestWithParam<std::string> {};

TEST_P(Page, ShowsCommandsThatRun) {
  const Scratch scratch;
  furnish(scratch);
  for (const auto& command : new_commands(GetParam())) {
    const std::string folder = std::filesystem::path(RAMIFY_PROGRAM).parent_path().string();
    const Ran ran = shell("cd " + scratch.path().string() + " && PATH=" + folder + ":$PATH " + mpi_as_root +
                          "OMPI_MCA_rmaps_base_oversubscribe=1 " + command);
    EXPECT_EQ(ran.code, 0) << command << '\n' << ran.err;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Page, testing::ValuesIn(pages_with_commands()),
                         [](const auto& page) { return name_of({page.param}); });

TEST(Pages, ShowCommands) {
  EXPECT_GE(pages_with_commands().size(), 7u);
}

TEST(Readme, TheVerdictTableIsTheReferenceRun) {
  const std::string readme = read_file(std::string(RAMIFY_SOURCE) + "/README.md");
  const std::string table = read_file(std::string(RAMIFY_SOURCE) + "/results/reference/quick/verdicts.txt");
  ASSERT_GT(table.size(), 500u);
  EXPECT_NE(readme.find("<!-- verdicts -->\n```\n" + table + "```\n"), std::string::npos);
}

TEST(Pages, TheCoverageTableIsTheProgramsOwn) {
  const std::string page = read_file(std::string(RAMIFY_SOURCE) + "/docs/coverage.md");
  const Ran ran = ramify("list coverage");
  ASSERT_EQ(ran.code, 0) << ran.err;
  ASSERT_GT(count_lines(ran.out), 20u);
  EXPECT_NE(page.find("```\n" + ran.out + "```\n"), std::string::npos)
      << "put what `ramify list coverage` prints into docs/coverage.md";
}

std::vector<std::string> split(const std::string& line, const std::string& by) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = line.find(by, begin)) != std::string::npos; begin = end + by.size())
    parts.push_back(line.substr(begin, end - begin));
  parts.push_back(line.substr(begin));
  return parts;
}

/// The column of a table of one row; "-" where it is empty or not there.
std::string only_value(const std::string& table, const std::string& column) {
  const auto lines = split(table, "\n");
  const auto names = split(lines[0], ","), values = split(lines[1], ",");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == column) return values[i].empty() ? "-" : values[i];
  return "-";
}

// | statistic | columns | trees | n = 0 | n = 1 | n = 2 | normalised | source |
TEST(Pages, TheStatisticsOfSmallTreesAreThoseMeasured) {
  const std::string page = read_file(std::string(RAMIFY_SOURCE) + "/docs/coverage.md");
  std::size_t statistics = 0;
  for (const std::string& line : split(page, "\n")) {
    const auto cells = split(line, " | ");
    if (!line.starts_with("| ") || cells.size() != 8 || cells[0] == "| statistic" || cells[0] == "| ---")
      continue;
    const std::string name = cells[0].substr(2);
    const bool by_order = name == "nodes" || name == "streams";
    const std::string column = by_order                 ? name + "_1"
                               : name == "ramification" ? name + "_1_1"
                                                        : split(cells[1], "..")[0];
    ++statistics;
    if (cells[5].find(" or ") != std::string::npos) continue;
    for (const int n : {0, 1, 2})
      EXPECT_EQ(
          only_value(ramify("sample --model bst --n " + std::to_string(n) + " --statistics " + name).out,
                     column),
          cells[3 + static_cast<std::size_t>(n)])
          << name << ", n = " << n;
  }
  EXPECT_EQ(statistics + 1, count_lines(ramify("list statistics").out));
}

TEST(Pages, TheSourcesTheyNameAreThere) {
  const std::filesystem::path project(RAMIFY_SOURCE);
  const std::regex path(R"((tests|src|experiments|configs)/[A-Za-z0-9_/]+\.(cpp|hpp|toml))");
  std::size_t named = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(project / "docs")) {
    const bool is_recipe =
        entry.path().filename().string().starts_with("add-a-");  // of files that are to be made
    if (entry.path().extension() != ".md" || is_recipe) continue;
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator match(text.begin(), text.end(), path), end; match != end; ++match, ++named)
      EXPECT_TRUE(std::filesystem::exists(project / match->str())) << entry.path() << ": " << match->str();
  }
  EXPECT_GE(named, 20u);
}

TEST(Readme, TheScriptsItNamesAreThere) {
  for (const char* script : {"scripts/reproduce", "scripts/test", "scripts/setup"})
    EXPECT_EQ(shell(std::string("test -x ") + script).code, 0) << script;
}

}  // namespace
}  // namespace ramify::test
