#include "ramify/io/json_writer.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/json_text.hpp"
#include "ramify/core/number.hpp"

namespace ramify {
namespace {

std::string json_of(const Field& field) {
  if (const auto* text = std::get_if<std::string>(&field)) return json_text(*text);
  const auto* real = std::get_if<Real>(&field);
  const bool is_null = real ? !std::isfinite(real->value) : !is_number(field);
  return is_null ? "null" : to_text(field);
}

std::string member(const std::pair<std::string, std::string>& member) {
  return fmt::format("{}: {}", json_text(member.first), member.second);
}

}  // namespace

std::string json_number(double value) {
  return std::isfinite(value) ? format_summary(value) : "null";
}

std::string json_list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string json_line(const JsonMembers& members) {
  std::vector<std::string> items;
  for (const auto& pair : members) items.push_back(member(pair));
  return fmt::format("{{{}}}", fmt::join(items, ", "));
}

std::string json_object(const JsonMembers& members, const std::string& indent) {
  std::vector<std::string> lines;
  for (const auto& pair : members) lines.push_back(fmt::format("{}  {}", indent, member(pair)));
  return fmt::format("{{\n{}\n{}}}", fmt::join(lines, ",\n"), indent);
}

std::string json_document(const std::vector<std::string>& items) {
  return fmt::format("[\n{}\n]\n", fmt::join(items, ",\n"));
}

std::string write_json(const Table& table) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    JsonMembers members;
    for (std::size_t c = 0; c < table.columns().size(); ++c)
      members.emplace_back(table.columns()[c], json_of(table.row(i)[c]));
    lines.push_back("  " + json_line(members));
  }
  return json_document(lines);
}

}  // namespace ramify
