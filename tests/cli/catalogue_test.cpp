// docs/catalogue.md says what every catalogue number is, and docs/design.md what every folder of the library
// holds.
#include <regex>
#include <set>

#include "program.hpp"
#include <gtest/gtest.h>

namespace ramify::test {
namespace {

const std::filesystem::path source = RAMIFY_SOURCE;

/// The first groups of all matches.
std::set<std::string> found_in(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

/// Whose paths are made of letters and numbers.
bool is_picture(const std::filesystem::path& path) {
  return path.extension() == ".svg" || path.extension() == ".png";
}

/// Everything that may cite the catalogue: sources, pages and lists of the program.
std::string citing_text() {
  std::string text;
  for (const char* folder : {"src", "experiments", "docs"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source / folder))
      if (entry.is_regular_file() && !is_picture(entry.path())) text += read_file(entry.path());
  for (const char* list : {"models", "statistics", "claims", "presets"})
    text += ramify(std::string("list ") + list).out;
  return text + read_file(source / "README.md");
}

// H1, R3 and the like after a # are labels of extended Newick; C6.1 and the like are parts of C6.
TEST(Catalogue, HasALineForEveryNumberThatIsCited) {
  const auto known = found_in(read_file(source / "docs/catalogue.md"), R"(\n\| ([A-IX][0-9]+) \|)");
  EXPECT_GE(known.size(), 70u);
  const auto cited = found_in(citing_text(), R"([^A-Za-z0-9_#.]([A-IX][0-9]+)[a-c]?(?![A-Za-z0-9_]))");
  EXPECT_GE(cited.size(), 50u);
  for (const auto& number : cited)
    EXPECT_TRUE(known.contains(number)) << number << ": give it a line in docs/catalogue.md";
}

TEST(Catalogue, HasALineForEveryClaimThatIsDecided) {
  const auto known = found_in(read_file(source / "docs/catalogue.md"), R"(\n\| (C[0-9]+) \|)");
  for (const auto& claim : found_in(ramify("list claims").out, R"(\n(C[0-9]+),)"))
    EXPECT_TRUE(known.contains(claim)) << claim;
}

TEST(Design, NamesEveryRoomOfTheLibrary) {
  const std::string page = read_file(source / "docs/design.md");
  const auto begin = page.find("| module | what it holds |"), end = page.find("\n\n", begin);
  std::set<std::string> rooms;
  for (const auto& entry : std::filesystem::directory_iterator(source / "src/ramify"))
    rooms.insert(entry.path().filename().string());
  auto named = found_in(page.substr(begin, end - begin), R"(\n\| ([a-z]+) \|)");
  EXPECT_EQ(named, rooms);
}

}  // namespace
}  // namespace ramify::test
