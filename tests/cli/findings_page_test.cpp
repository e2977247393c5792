// docs/findings.md: every verdict of the quick ledger is on it, and every number with a part's name behind it
// is the ledger's.
#include <map>
#include <regex>
#include <set>

#include "page_numbers.hpp"
#include "program.hpp"
#include <gtest/gtest.h>

#include "ramify/text/csv_reader.hpp"

namespace ramify::test {
namespace {

const CsvData& ledger_rows() {
  static const CsvData table =
      CsvData::read(std::string(RAMIFY_SOURCE) + "/results/reference/quick/verdicts.csv");
  return table;
}

std::optional<std::size_t> row_of_part(const std::string& part) {
  for (std::size_t row = 0; row < ledger_rows().rows(); ++row)
    if (ledger_rows().at(row, "claim") == part) return row;
  return std::nullopt;
}

std::string findings_text() {
  return read_file(std::string(RAMIFY_SOURCE) + "/docs/findings.md");
}

/// What was claimed, what was found, an end of its interval, or what holds instead: "1/2 (0.5)".
bool is_of_row(const std::string& number, std::size_t row) {
  for (const char* column : {"theory", "estimate", "lower", "upper"})
    if (is_rounded(number, ledger_rows().real(row, column))) return true;
  const std::string instead(ledger_rows().at(row, "instead"));
  const auto bracket = instead.rfind('(');
  return bracket != std::string::npos && is_rounded(number, std::stod(instead.substr(bracket + 1)));
}

/// Half of the interval of the true value; the table has its ends rounded, a page rounds it up.
void expect_error(const std::string& error, std::size_t row, const std::string& where) {
  const double half = (ledger_rows().real(row, "upper") - ledger_rows().real(row, "lower")) / 2;
  EXPECT_GE(std::stod(error), half - 0.501 * last_digit(error)) << where;
  EXPECT_LE(std::stod(error), half + 1.001 * last_digit(error)) << where;
}

const std::string number_pattern = R"((-?[0-9]+(?:\.[0-9]+)?(?:e-?[0-9]+)?))";
const std::string error_pattern = R"((?: \+- ([0-9]+(?:\.[0-9]+)?(?:e-?[0-9]+)?))?)";

// 0.8983790551 +- 0.0000000018 (C20.2)
TEST(FindingsPage, HasTheNumbersOfTheLedger) {
  const std::string text = findings_text();
  const std::regex marked(number_pattern + error_pattern + R"( \(([CH][0-9]+\.[0-9]+)\))");
  std::size_t numbers = 0, marks = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), marked), end; match != end; ++match, ++numbers) {
    const std::string where = match->str();
    const auto row = row_of_part((*match)[3]);
    ASSERT_TRUE(row) << where;
    EXPECT_TRUE(is_of_row((*match)[1], *row)) << where;
    if ((*match)[2].matched) expect_error((*match)[2], *row, where);
  }
  const std::regex mark(R"(\([CH][0-9]+\.[0-9]+\))");
  for (std::sregex_iterator match(text.begin(), text.end(), mark), end; match != end; ++match) ++marks;
  EXPECT_EQ(numbers, marks) << "a part's name in brackets stands behind a number";
  EXPECT_GE(numbers, 80u);
}

/// The parts of "C20.1, C20.3 to C20.5".
std::set<std::string> parts_listed(const std::string& list) {
  std::set<std::string> parts;
  const std::regex range(R"(([CH][0-9]+)\.([0-9]+)(?: to [CH][0-9]+\.([0-9]+))?)");
  for (std::sregex_iterator match(list.begin(), list.end(), range), end; match != end; ++match) {
    const int first = std::stoi((*match)[2]), last = (*match)[3].matched ? std::stoi((*match)[3]) : first;
    for (int i = first; i <= last; ++i) parts.insert((*match)[1].str() + "." + std::to_string(i));
  }
  return parts;
}

// Verdicts: C20.1 reproduced; C20.2, C20.3 refuted.
TEST(FindingsPage, HasEveryVerdictOfTheLedger) {
  const std::string text = findings_text();
  std::map<std::string, std::string> found;
  const std::regex group(
      R"((?:Verdicts:|;) ((?:[CH][0-9]+\.[0-9]+(?:, | to )?)+) (reproduced|refuted|inconclusive))");
  for (std::sregex_iterator match(text.begin(), text.end(), group), end; match != end; ++match)
    for (const auto& part : parts_listed((*match)[1])) {
      EXPECT_FALSE(found.contains(part)) << part << " stands there twice";
      found[part] = (*match)[2];
    }
  for (std::size_t row = 0; row < ledger_rows().rows(); ++row)
    EXPECT_EQ(found[std::string(ledger_rows().at(row, "claim"))], ledger_rows().at(row, "verdict"))
        << ledger_rows().at(row, "claim");
  EXPECT_EQ(found.size(), ledger_rows().rows());
}

// | part | what is printed | claimed | found | what holds instead |
TEST(FindingsPage, ListsWhatIsRefutedWithItsNumbers) {
  std::istringstream page(findings_text());
  std::set<std::string> listed, refuted;
  const std::regex found_cell(number_pattern + error_pattern);
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| C") && !line.starts_with("| H")) continue;
    const auto cells = cells_of(line);
    const auto row = row_of_part(cells[0]);
    ASSERT_TRUE(row && cells.size() == 5) << line;
    listed.insert(cells[0]);
    EXPECT_TRUE(is_rounded(cells[2], ledger_rows().real(*row, "theory"))) << line;
    std::smatch found;
    ASSERT_TRUE(std::regex_match(cells[3], found, found_cell)) << line;
    EXPECT_TRUE(is_rounded(found[1], ledger_rows().real(*row, "estimate"))) << line;
    expect_error(found[2], *row, line);
  }
  for (std::size_t row = 0; row < ledger_rows().rows(); ++row)
    if (ledger_rows().at(row, "verdict") == "refuted")
      refuted.insert(std::string(ledger_rows().at(row, "claim")));
  EXPECT_EQ(listed, refuted);
  const std::string counted = std::to_string(ledger_rows().rows()) +
                              " statements with a number in each, and decided them: " +
                              std::to_string(ledger_rows().rows() - refuted.size()) + " hold, " +
                              std::to_string(refuted.size()) + " do not";
  EXPECT_NE(findings_text().find(counted), std::string::npos) << counted;
}

}  // namespace
}  // namespace ramify::test
