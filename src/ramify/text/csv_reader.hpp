#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/error.hpp"

namespace ramify {

/// One field of a CSV file and where it starts.
struct CsvField {
  std::string text;
  std::size_t line;
  std::size_t column;  ///< characters from 1, not bytes
};

/// A table read from RFC 4180 text: a header, then rows of the same length, every field with its place in the
/// file.
///
/// Accepted beside the RFC: a byte order mark, `\n` or `\r\n`, lines that begin with # before the header,
/// empty lines, no newline at the end. Rows are numbered from 0.
class CsvData {
 public:
  /// Throws Error with file:line:column for a missing header, a column named twice, a row of another length
  /// than the header, a quote that is never closed or stands inside a field.
  static CsvData parse(std::string_view text, std::string_view name);
  /// parse() of a file; throws Error where it cannot be read.
  static CsvData read(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  const std::vector<std::string>& header() const { return header_; }
  std::size_t rows() const { return rows_.size(); }

  std::optional<std::size_t> column(std::string_view name) const;
  /// Throws Error, naming the nearest columns, where there is none of that name.
  std::size_t require_column(std::string_view name) const;

  /// A field as it is in the file, unquoted. Throws Error for an unknown column.
  std::string_view at(std::size_t row, std::string_view column_name) const;
  /// Where the row starts; line only.
  SourceLocation where(std::size_t row) const;
  SourceLocation where(std::size_t row, std::string_view column_name) const;

  // Typed fields: white space around the value is ignored; each throws Error with the place of the field
  // where it is something else. The optional ones give nothing for an empty field.
  std::string text(std::size_t row, std::string_view column_name) const;  ///< not empty
  double real(std::size_t row, std::string_view column_name) const;       ///< finite; "1/4.35" too
  std::uint64_t count(std::size_t row, std::string_view column_name) const;
  std::optional<double> optional_real(std::size_t row, std::string_view column_name) const;
  std::optional<std::uint64_t> optional_count(std::size_t row, std::string_view column_name) const;

 private:
  CsvData() = default;
  const CsvField& field(std::size_t row, std::string_view column_name) const;
  [[noreturn]] void fail(std::size_t row, std::string_view column_name, std::string_view why,
                         std::string_view remedy) const;

  std::string name_;
  std::vector<std::string> header_;
  std::vector<std::vector<CsvField>> rows_;
};

}  // namespace ramify
