#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ramify {

/// A real number and how it is printed, the same bytes on every machine. NaN stands for no value.
struct Real {
  enum class Notation : std::uint8_t {
    significant,  ///< at most so many significant digits
    fixed,        ///< so many decimals
    exact,        ///< the shortest text that reads back as the same double
  };

  double value;
  Notation notation;
  int digits = 0;
};

/// A field of a table: nothing, a text, a whole number or a real one.
using Field = std::variant<std::monostate, std::string, std::int64_t, std::uint64_t, Real>;

/// The field as CSV and aligned text show it; empty for nothing and for NaN.
std::string to_text(const Field& field);

/// The field as a number; NaN for nothing and for a text.
double to_number(const Field& field);

inline bool is_number(const Field& field) {
  return !std::holds_alternative<std::monostate>(field) && !std::holds_alternative<std::string>(field);
}

/// One row, field by field: Row().text("bst").whole(n).summary(mean).
class Row {
 public:
  Row& nothing();
  Row& text(std::string_view value);
  Row& texts(std::initializer_list<std::string_view> values);
  Row& whole(std::signed_integral auto value) { return add(std::int64_t{value}); }
  Row& whole(std::unsigned_integral auto value) { return add(std::uint64_t{value}); }
  /// 10 significant digits.
  Row& summary(double value) { return significant(value, 10); }
  Row& significant(double value, int digits) { return add({value, Real::Notation::significant, digits}); }
  Row& fixed(double value, int decimals) { return add({value, Real::Notation::fixed, decimals}); }
  /// Reads back as the same double.
  Row& exact(double value) { return add({value, Real::Notation::exact}); }
  /// As another table has it.
  Row& field(const Field& field);

 private:
  friend class Table;

  Row& add(std::int64_t value);
  Row& add(std::uint64_t value);
  Row& add(Real value);

  std::vector<Field> fields_;
};

/// Named columns and rows of typed fields, until a writer makes a text of them (csv_writer.hpp,
/// json_writer.hpp, text_writer.hpp).
class Table {
 public:
  /// @param columns  one or more
  explicit Table(std::vector<std::string> columns);

  /// Makes room for so many rows: a table of millions grows without copies of itself.
  void reserve(std::size_t rows) { fields_.reserve(rows * columns_.size()); }

  /// The row has a field for each column.
  void add(Row row);

  const std::vector<std::string>& columns() const { return columns_; }
  std::size_t rows() const { return fields_.size() / columns_.size(); }
  std::span<const Field> row(std::size_t index) const;
  /// @param column  a name; the table has it
  const Field& at(std::size_t row, std::string_view column) const;
  double number(std::size_t row, std::string_view column) const { return to_number(at(row, column)); }
  /// Numbers and nothing but them, where there is a field at all: such a column is set to the right.
  bool holds_numbers(std::size_t column) const;
  /// The columns of these names alone, as far as it has them, in their order here. One at least is there.
  Table selected(std::initializer_list<std::string_view> names) const;

 private:
  std::vector<std::string> columns_;
  std::vector<Field> fields_;  // row after row
};

}  // namespace ramify
