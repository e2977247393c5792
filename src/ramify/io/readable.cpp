#include "ramify/io/readable.hpp"

#include <algorithm>
#include <cmath>

namespace ramify {
namespace {

bool is_empty(const Field& field) {
  const auto* text = std::get_if<std::string>(&field);
  const auto* real = std::get_if<Real>(&field);
  return std::holds_alternative<std::monostate>(field) || (text != nullptr && text->empty()) ||
         (real != nullptr && std::isnan(real->value));
}

/// Columns that some row has a value in; all where there is no row.
std::vector<std::size_t> filled_columns(const Table& table) {
  std::vector<std::size_t> filled;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    bool some = table.rows() == 0;
    for (std::size_t r = 0; r < table.rows() && !some; ++r) some = !is_empty(table.row(r)[c]);
    if (some) filled.push_back(c);
  }
  return filled;
}

void add_real(Row& row, const Real& real) {
  constexpr int summary_digits = 5, exact_digits = 10;
  switch (real.notation) {
    case Real::Notation::fixed:
      row.fixed(real.value, real.digits);
      break;
    case Real::Notation::exact:
      row.significant(real.value, exact_digits);
      break;
    case Real::Notation::significant:
      row.significant(real.value, std::min(real.digits, summary_digits));
  }
}

void add_field(Row& row, const Field& field) {
  if (const auto* real = std::get_if<Real>(&field)) return add_real(row, *real);
  if (const auto* text = std::get_if<std::string>(&field))
    row.text(*text);
  else if (const auto* whole = std::get_if<std::int64_t>(&field))
    row.whole(*whole);
  else if (const auto* count = std::get_if<std::uint64_t>(&field))
    row.whole(*count);
  else
    row.nothing();
}

}  // namespace

Table readable(const Table& table) {
  const auto filled = filled_columns(table);
  if (filled.empty()) return table;
  std::vector<std::string> header;
  for (const std::size_t c : filled) header.push_back(table.columns()[c]);
  Table result(std::move(header));
  for (std::size_t r = 0; r < table.rows(); ++r) {
    Row row;
    for (const std::size_t c : filled) add_field(row, table.row(r)[c]);
    result.add(std::move(row));
  }
  return result;
}

}  // namespace ramify
