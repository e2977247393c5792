#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ramify {

/// How the numbers of a file are written: whether "." or "," is their decimal mark, learnt from those fields
/// that can be read one way only.
///
/// "8,6", "0,123", "1234,567" and "1.234,5" have a decimal comma, "8.6" and "1,234.5" a decimal point;
/// "1,234" alone may be either, and "1.234" too where the file has decimal commas. Thousands may also be
/// parted by blanks, apostrophes and low lines.
class NumberStyle {
 public:
  /// @param comma_parts_fields  the file's fields are parted by commas: then a comma is no decimal mark
  explicit NumberStyle(bool comma_parts_fields) : decimal_point_(comma_parts_fields) {}

  /// Learns from a field of a column of numbers.
  void see(std::string_view field);

  /// The field as a plain number, "1234.5"; nothing where it is none, or can be read two ways.
  std::optional<std::string> plain(std::string_view field) const;
  /// A finite real. "1.234" is read with a decimal point unless the file has decimal commas.
  std::optional<double> real(std::string_view field) const;
  /// A whole number from 0. "1.234" and "1.000" are refused unless the file has decimal commas; "1.0" is 1.
  std::optional<std::uint64_t> count(std::string_view field) const;

  /// Whether that is why there is no number: "1,234" in a file that does not say which mark is which.
  bool two_ways(std::string_view field, bool whole) const;

 private:
  bool decimal_point_ = false, decimal_comma_ = false;
};

}  // namespace ramify
