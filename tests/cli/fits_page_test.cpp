// results/reference/fits*.csv: every data set x every family; and docs/fits.md, which reads them.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "page_numbers.hpp"
#include "program.hpp"
#include <gtest/gtest.h>

#include "ramify/family/family.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify::test {
namespace {

const std::string project = RAMIFY_SOURCE;

CsvData reference(const std::string& name) {
  return CsvData::read(project + "/results/reference/" + name);
}

/// The shipped tables of counts, by the names that fits have for them.
std::vector<std::string> count_tables() {
  std::vector<std::string> tables;
  for (const auto& entry : std::filesystem::directory_iterator(project + "/data"))
    if (entry.path().extension() == ".csv" &&
        read_file(entry.path()).find("\norder,count") != std::string::npos)
      tables.push_back(entry.path().stem().string());
  return tables;
}

TEST(ReferenceFits, HaveEveryTableOfCountsByEveryFamily) {
  const CsvData fits = reference("fits.csv");
  std::map<std::string, std::size_t> rows;
  for (std::size_t row = 0; row < fits.rows(); ++row)
    ++rows[std::string(fits.at(row, "data")) + " " + std::string(fits.at(row, "model"))];
  ASSERT_GE(count_tables().size(), 9u);
  for (const std::string& table : count_tables())
    for (const Family& family : families())
      EXPECT_GE(rows[table + " " + std::string(family.name)], 1u)
          << table << ' ' << family.name << ": run scripts/fits";
}

/// Of the rows of a data set and a family what does not depend on the other families.
std::vector<std::string> rows_of(const CsvData& fits, const std::string& data, const std::string& family) {
  std::vector<std::string> found;
  for (std::size_t row = 0; row < fits.rows(); ++row) {
    if (fits.at(row, "data") != data || fits.at(row, "model") != family) continue;
    std::string text;
    for (const char* column : {"parameter", "estimate", "standard_error", "lower", "upper", "observable", "n",
                               "log_likelihood", "aic", "bic", "misfit", "misfit_p", "likelihood_ratio",
                               "bootstrap_lower", "bootstrap_upper", "bootstrap_bias", "status"})
      text += std::string(fits.at(row, column)) + ",";
    found.push_back(text);
  }
  return found;
}

/// A subset, as a user would run it.
void expect_fitted_anew(const std::string& table, const std::vector<std::string>& data,
                        const std::vector<std::string>& families, const std::string& options) {
  const Scratch scratch;
  std::string files, names;
  for (const auto& name : data) files += " data/" + name + ".csv";
  for (const auto& name : families) names += (names.empty() ? "" : ",") + name;
  const std::string anew = (scratch / "fits.csv").string();
  const Ran ran = ramify("fit" + files + " --model '" + names + "' --csv --seed 1996 -o " + anew + options);
  ASSERT_EQ(ran.code, 0) << ran.err;
  const CsvData committed = reference(table), fitted = CsvData::read(anew);
  for (const auto& name : data)
    for (const auto& family : families) {
      const auto rows = rows_of(fitted, name, family);
      EXPECT_FALSE(rows.empty()) << name << ' ' << family;
      EXPECT_EQ(rows, rows_of(committed, name, family)) << name << ' ' << family << ": run scripts/fits";
    }
}

TEST(ReferenceFits, AreThoseOfThisProgram) {
  expect_fitted_anew("fits.csv", {"new_hope_creek", "airway_ct", "apple_braeburn"},
                     {"patricia", "aldous", "ford", "bst", "catalan"}, "");
  expect_fitted_anew("fits_bootstrap.csv", {"new_hope_creek"}, {"ford", "bst", "catalan"},
                     " --bootstrap 200");
}

/// The first row of a data set's fit by a family, or its test of a simpler one.
std::size_t row_of(const CsvData& fits, const std::string& data, const std::string& family,
                   const std::string& parameter = "") {
  for (std::size_t row = 0; row < fits.rows(); ++row)
    if (fits.at(row, "data") == data && fits.at(row, "model") == family &&
        (parameter.empty() || fits.at(row, "parameter") == parameter))
      return row;
  ADD_FAILURE() << "no " << data << ' ' << family << ' ' << parameter;
  return 0;
}

/// | data | n | family | parameter | 95 % | AIC - best |, and | misfit p | where the bootstrap says it
void expect_fit(const std::vector<std::string>& cells) {
  const bool has_misfit = cells.size() > 6;
  const CsvData fits = reference(has_misfit ? "fits_bootstrap.csv" : "fits.csv");
  const std::size_t row = row_of(fits, cells[0], cells[2]);
  const std::string where = cells[0] + " " + cells[2];
  EXPECT_EQ(cells[1], fits.at(row, "n")) << where;
  if (has_misfit) {
    EXPECT_TRUE(is_rounded(cells[6], fits.real(row, "misfit_p"))) << where;
  }
  if (cells[3].empty()) return;
  const auto equals = cells[3].find(" = ");
  EXPECT_EQ(cells[3].substr(0, equals), fits.at(row, "parameter")) << where;
  EXPECT_TRUE(is_rounded(cells[3].substr(equals + 3), fits.real(row, "estimate"))) << where;
  const auto dots = cells[4].find(" .. ");
  const std::string low = cells[4].substr(0, dots), high = cells[4].substr(dots + 4);
  for (const auto& [end, column] : {std::pair(low, "lower"), std::pair(high, "upper")})
    EXPECT_TRUE(end == fits.at(row, column) || is_rounded(end, fits.real(row, column)))
        << where << ' ' << column;
}

/// | simpler family | in | likelihood ratio | P |
void expect_test(const std::string& data, const std::vector<std::string>& cells) {
  const CsvData fits = reference("fits_bootstrap.csv");
  const std::size_t row = row_of(fits, data, cells[1], cells[0] + "_suffices");
  EXPECT_TRUE(is_rounded(cells[2], fits.real(row, "likelihood_ratio"))) << data << ' ' << cells[0];
  EXPECT_TRUE(is_rounded(cells[3], fits.real(row, "estimate"))) << data << ' ' << cells[0];
}

TEST(FitsPage, HasTheNumbersOfTheTables) {
  std::istringstream page(read_file(project + "/docs/fits.md"));
  const auto tables = count_tables();
  std::size_t fits = 0, tests = 0;
  std::string data;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("**The walnut**")) data = "walnut";
    if (line.starts_with("**New Hope Creek**")) data = "new_hope_creek";
    if (!line.starts_with("| ")) continue;
    const auto cells = cells_of(line);
    if (std::ranges::find(tables, cells[0]) != tables.end()) {
      expect_fit(cells);
      ++fits;
    } else if (cells.size() == 4 && (cells[1] == "aldous" || cells[1] == "ford")) {
      expect_test(data, cells);
      ++tests;
    }
  }
  EXPECT_GE(fits, 25u);
  EXPECT_GE(tests, 6u);
}

}  // namespace
}  // namespace ramify::test
