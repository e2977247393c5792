#include "ramify/io/table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "ramify/core/contract.hpp"
#include "ramify/core/number.hpp"

namespace ramify {
namespace {

struct ToText {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const std::string& text) const { return text; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(std::uint64_t value) const { return std::to_string(value); }

  std::string operator()(const Real& real) const {
    if (std::isnan(real.value)) return {};
    switch (real.notation) {
      case Real::Notation::significant:
        return format_significant(real.value, real.digits);
      case Real::Notation::fixed:
        return fmt::format("{:.{}f}", real.value, real.digits);
      case Real::Notation::exact:
        break;
    }
    return format_exact(real.value);
  }
};

struct ToNumber {
  double operator()(std::monostate) const { return std::numeric_limits<double>::quiet_NaN(); }
  double operator()(const std::string&) const { return std::numeric_limits<double>::quiet_NaN(); }
  double operator()(std::int64_t value) const { return static_cast<double>(value); }
  double operator()(std::uint64_t value) const { return static_cast<double>(value); }
  double operator()(const Real& real) const { return real.value; }
};

}  // namespace

std::string to_text(const Field& field) {
  return std::visit(ToText(), field);
}

double to_number(const Field& field) {
  return std::visit(ToNumber(), field);
}

Row& Row::nothing() {
  fields_.emplace_back();
  return *this;
}

Row& Row::text(std::string_view value) {
  fields_.emplace_back(std::in_place_type<std::string>, value);
  return *this;
}

Row& Row::texts(std::initializer_list<std::string_view> values) {
  for (const auto value : values) text(value);
  return *this;
}

Row& Row::add(std::int64_t value) {
  fields_.emplace_back(value);
  return *this;
}

Row& Row::add(std::uint64_t value) {
  fields_.emplace_back(value);
  return *this;
}

Row& Row::add(Real value) {
  fields_.emplace_back(value);
  return *this;
}

Row& Row::field(const Field& field) {
  fields_.push_back(field);
  return *this;
}

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {
  RAMIFY_EXPECTS(!columns_.empty());
}

void Table::add(Row row) {
  RAMIFY_EXPECTS(row.fields_.size() == columns_.size());
  std::move(row.fields_.begin(), row.fields_.end(), std::back_inserter(fields_));
}

std::span<const Field> Table::row(std::size_t index) const {
  return std::span(fields_).subspan(index * columns_.size(), columns_.size());
}

const Field& Table::at(std::size_t row, std::string_view column) const {
  const auto place = std::ranges::find(columns_, column);
  RAMIFY_EXPECTS(place != columns_.end());
  return fields_[row * columns_.size() + static_cast<std::size_t>(place - columns_.begin())];
}

bool Table::holds_numbers(std::size_t column) const {
  bool some = false;
  for (std::size_t r = 0; r < rows(); ++r) {
    const Field& field = row(r)[column];
    if (std::holds_alternative<std::string>(field)) return false;
    some = some || is_number(field);
  }
  return some;
}

Table Table::selected(std::initializer_list<std::string_view> names) const {
  std::vector<std::string> chosen;
  for (const std::string_view name : names)
    if (std::ranges::find(columns_, name) != columns_.end()) chosen.emplace_back(name);
  Table result(chosen);
  for (std::size_t r = 0; r < rows(); ++r) {
    Row fields;
    for (const std::string& name : chosen) fields.field(at(r, name));
    result.add(std::move(fields));
  }
  return result;
}

}  // namespace ramify
