#pragma once

#include <concepts>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/number.hpp"

namespace ramify {

/// Adds one row of RFC 4180 to text: quotes only where a field needs them ("beta(10,80)"), lines end in \n.
void append_csv_row(std::string& text, std::span<const std::string> fields);

/// The same to a stream, for tables too long to hold.
void write_csv_row(std::ostream& stream, std::span<const std::string> fields);

/// One row, field by field: CsvRow().text("bst").whole(n).summary(mean).
class CsvRow {
 public:
  CsvRow& text(std::string_view value) { return add(std::string(value)); }
  CsvRow& whole(std::integral auto value) { return add(std::to_string(value)); }
  /// 10 significant digits, the same bytes on every machine; empty for NaN.
  CsvRow& summary(double value) { return add(format_summary(value)); }
  /// Reads back as the same double; empty for NaN.
  CsvRow& exact(double value) { return add(value == value ? format_exact(value) : std::string()); }

  const std::vector<std::string>& fields() const { return fields_; }

 private:
  CsvRow& add(std::string field) {
    fields_.push_back(std::move(field));
    return *this;
  }

  std::vector<std::string> fields_;
};

/// A table that is held, then written: header and rows of the same length.
class CsvTable {
 public:
  explicit CsvTable(std::vector<std::string> header) : header_(std::move(header)) {}

  /// The row has as many fields as the header.
  void add(std::vector<std::string> row);
  void add(const CsvRow& row) { add(row.fields()); }

  const std::vector<std::string>& header() const { return header_; }
  const std::vector<std::vector<std::string>>& rows() const { return rows_; }
  std::string text() const;

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace ramify
