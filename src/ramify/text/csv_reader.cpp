#include "ramify/text/csv_reader.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/nearest_name.hpp"
#include "ramify/core/number.hpp"
#include "ramify/text/csv_scanner.hpp"
#include "ramify/text/located_error.hpp"
#include "ramify/text/text_file.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

std::vector<std::string> read_header(detail::CsvScanner& scanner, std::string_view name) {
  scanner.skip_comments();
  const auto fields = scanner.next_row();
  if (!fields)
    throw error_at({std::string(name), 0, 0}, "no header",
                   "a table starts with a line that names its columns", "add one, such as order,count");
  std::vector<std::string> header;
  for (const auto& field : *fields) {
    if (std::find(header.begin(), header.end(), field.text) != header.end())
      throw error_at({std::string(name), field.line, field.column},
                     fmt::format("column '{}' twice", field.text), "each column has its own name",
                     "rename or remove one");
    header.push_back(field.text);
  }
  return header;
}

}  // namespace

CsvData CsvData::parse(std::string_view text, std::string_view name) {
  CsvData data;
  data.name_ = name;
  detail::CsvScanner scanner(text, name);
  data.header_ = read_header(scanner, name);
  while (auto row = scanner.next_row()) {
    if (row->size() != data.header_.size()) {
      // The place is the first field too many, or the last one of a short row.
      const CsvField& odd = (*row)[std::min(row->size() - 1, data.header_.size())];
      throw error_at({std::string(name), odd.line, odd.column},
                     fmt::format("a row of {} field(s)", row->size()),
                     fmt::format("the header has {}", data.header_.size()),
                     "give every row as many fields as the header, and quote fields that hold a comma");
    }
    data.rows_.push_back(*std::move(row));
  }
  return data;
}

CsvData CsvData::read(const std::filesystem::path& path) {
  return parse(read_text_file(path), path.string());
}

std::optional<std::size_t> CsvData::column(std::string_view name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - header_.begin());
}

std::size_t CsvData::require_column(std::string_view name) const {
  if (const auto index = column(name)) return *index;
  throw error_at({name_, 0, 0}, fmt::format("no column '{}'", name),
                 fmt::format("the columns are {}", fmt::join(header_, ", ")),
                 fmt::format("{}add or rename a column", did_you_mean(name, header_)));
}

const CsvField& CsvData::field(std::size_t row, std::string_view column_name) const {
  RAMIFY_EXPECTS(row < rows_.size());
  return rows_[row][require_column(column_name)];
}

std::string_view CsvData::at(std::size_t row, std::string_view column_name) const {
  return field(row, column_name).text;
}

SourceLocation CsvData::where(std::size_t row) const {
  RAMIFY_EXPECTS(row < rows_.size());
  return {name_, rows_[row].front().line, 0};
}

SourceLocation CsvData::where(std::size_t row, std::string_view column_name) const {
  const CsvField& found = field(row, column_name);
  return {name_, found.line, found.column};
}

void CsvData::fail(std::size_t row, std::string_view column_name, std::string_view why,
                   std::string_view remedy) const {
  throw error_at(where(row, column_name), fmt::format("{} = '{}'", column_name, at(row, column_name)), why,
                 remedy);
}

std::string CsvData::text(std::size_t row, std::string_view column_name) const {
  const auto value = trimmed(at(row, column_name));
  if (value.empty()) fail(row, column_name, "it must not be empty", "fill it in");
  return std::string(value);
}

double CsvData::real(std::size_t row, std::string_view column_name) const {
  if (const auto value = optional_real(row, column_name)) return *value;
  fail(row, column_name, "a number is needed here", "fill it in");
}

std::uint64_t CsvData::count(std::size_t row, std::string_view column_name) const {
  if (const auto value = optional_count(row, column_name)) return *value;
  fail(row, column_name, "a whole number is needed here", "fill it in");
}

std::optional<double> CsvData::optional_real(std::size_t row, std::string_view column_name) const {
  const auto value = trimmed(at(row, column_name));
  if (value.empty()) return std::nullopt;
  const auto number = parse_real(value);
  if (!number) fail(row, column_name, "not a finite number", "write it like 0.23, 1e-3 or 1/4.35");
  return number;
}

std::optional<std::uint64_t> CsvData::optional_count(std::size_t row, std::string_view column_name) const {
  const auto value = trimmed(at(row, column_name));
  if (value.empty()) return std::nullopt;
  const auto number = parse_count(value);
  if (!number) fail(row, column_name, "not a whole number from 0", "write it like 579, 1_000_000 or 1e6");
  return number;
}

}  // namespace ramify
