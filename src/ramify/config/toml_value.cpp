#include "ramify/config/toml_value.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/core/number.hpp"

namespace ramify::detail {
namespace {

SourceLocation place(std::string_view file, const toml::source_position& position) {
  return {std::string(file), position.line, position.column};
}

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "a whole number";
    case toml::node_type::floating_point:
      return "a number with a fraction or an exponent";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

/// A float that stands for a whole number: 1e6.
std::optional<std::int64_t> whole_value(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return integer->get();
  const auto* real = node.as_floating_point();
  if (real == nullptr || std::abs(real->get()) > 0x1p62 || real->get() != std::floor(real->get()))
    return std::nullopt;
  return static_cast<std::int64_t>(real->get());
}

std::string shown(const toml::node& node) {
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  return fmt::format("{}", node.as_floating_point()->get());
}

}  // namespace

SourceLocation TomlValue::where() const {
  return place(file_, node_->source().begin);
}

void TomlValue::fail(std::string_view problem, std::string_view why, std::string_view remedy) const {
  throw error_at(where(), problem, why, remedy);
}

void TomlValue::fail_type(const Expected& expected) const {
  fail(fmt::format("{} is {}", key_, type_name(*node_)), fmt::format("it must be {}", expected.what),
       fmt::format("write {}", expected.example));
}

std::string TomlValue::text(const Expected& expected) const {
  const auto* value = node_->as_string();
  if (value == nullptr) fail_type(expected);
  return value->get();
}

bool TomlValue::boolean(const Expected& expected) const {
  const auto* value = node_->as_boolean();
  if (value == nullptr) fail_type(expected);
  return value->get();
}

std::uint64_t TomlValue::whole(std::uint64_t least, std::uint64_t most, const Expected& expected) const {
  if (!is_number()) fail_type(expected);
  const auto value = whole_value(*node_);
  if (value && *value >= 0 && static_cast<std::uint64_t>(*value) >= least &&
      static_cast<std::uint64_t>(*value) <= most)
    return static_cast<std::uint64_t>(*value);
  fail(fmt::format("{} = {}", key_, shown(*node_)),
       fmt::format("it must be {} from {} to {}", expected.what, least, most),
       fmt::format("write {}", expected.example));
}

double TomlValue::real(const Expected& expected) const {
  std::optional<double> value;
  if (const auto* integer = node_->as_integer()) value = static_cast<double>(integer->get());
  if (const auto* number = node_->as_floating_point()) value = number->get();
  if (const auto* text = node_->as_string()) {
    value = parse_real(text->get());
    if (!value)
      fail(fmt::format("{} = '{}'", key_, text->get()), fmt::format("it must be {}", expected.what),
           fmt::format("write {}", expected.example));
  }
  if (!value) fail_type(expected);
  return *value;
}

std::vector<TomlValue> TomlValue::elements(const Expected& expected) const {
  const auto* array = node_->as_array();
  if (array == nullptr) fail_type(expected);
  if (array->empty())
    fail(fmt::format("{} is empty", key_), fmt::format("it must be {}", expected.what),
         fmt::format("write {}", expected.example));
  std::vector<TomlValue> values;
  for (const auto& element : *array) values.emplace_back(file_, key_, element);
  return values;
}

const toml::table& TomlValue::table(const Expected& expected) const {
  const auto* value = node_->as_table();
  if (value == nullptr) fail_type(expected);
  return *value;
}

void TomlTable::require_known(std::string_view owner, std::span<const std::string_view> keys) const {
  const toml::key* unknown = nullptr;
  for (const auto& [key, value] : *table_) {
    if (std::find(keys.begin(), keys.end(), key.str()) != keys.end()) continue;
    if (unknown == nullptr || key.source().begin < unknown->source().begin) unknown = &key;
  }
  if (unknown == nullptr) return;
  const std::vector<std::string> known(keys.begin(), keys.end());
  throw error_at(place(file_, unknown->source().begin), fmt::format("unknown key '{}'", unknown->str()),
                 fmt::format("{} has {}", owner, fmt::join(known, ", ")),
                 fmt::format("{}remove or rename it", did_you_mean(unknown->str(), known)));
}

std::optional<TomlValue> TomlTable::find(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) return std::nullopt;
  return TomlValue(file_, std::string(key), *node);
}

std::vector<TomlValue> TomlTable::values() const {
  std::vector<TomlValue> values;
  for (const auto& [key, value] : *table_) values.emplace_back(file_, std::string(key.str()), value);
  std::sort(values.begin(), values.end(), [](const TomlValue& a, const TomlValue& b) {
    const SourceLocation x = a.where(), y = b.where();
    return std::pair(x.line, x.column) < std::pair(y.line, y.column);
  });
  return values;
}

toml::table parse_toml(std::string_view text, std::string_view name) {
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw error_at(place(name, error.source().begin), "this is not TOML", error.description(),
                   "mend this line; docs/config.md has an example");
  }
}

}  // namespace ramify::detail
