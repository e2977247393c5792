#include "ramify/format/mtg_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/text/trimmed.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify::detail {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

bool is_mark(char c) {
  return c == '/' || c == '<' || c == '+';
}

}  // namespace

/// The scale of the longest class name that the label begins with: "S12" is of class S unless there is one
/// called S1.
const unsigned* MtgGraph::known_scale(std::string_view label) const {
  for (std::size_t size = label.size(); size > 0; --size)
    if (const auto found = header_.scales.find(label.substr(0, size)); found != header_.scales.end())
      return &found->second;
  return nullptr;
}

unsigned MtgGraph::scale_of_class(std::string_view label) const {
  if (const unsigned* scale = known_scale(label)) return *scale;
  // The scene of several plants, class $, goes by any name.
  const bool has_scene = header_.scales.contains("$");
  if (has_scene && vertices_.empty()) return 0;
  throw source_.error(label, fmt::format("entity '{}' of no class", excerpt(label)),
                      "the section CLASSES names them all, with a scale from 1", "add its class");
}

void MtgGraph::require_whole_scene() const {
  if (vertices_.empty() || vertices_[0].scale > 0 || vertices_[0].last_part != none) return;
  throw source_.error(vertices_[0].label, fmt::format("entity '{}' of no class", excerpt(vertices_[0].label)),
                      "the section CLASSES names them all, with a scale from 1", "add its class");
}

std::uint32_t MtgGraph::raised(std::uint32_t vertex, unsigned scale) const {
  while (vertex != none && vertices_[vertex].scale > scale) vertex = vertices_[vertex].complex;
  return vertex;
}

std::uint32_t MtgGraph::deepest_part(std::uint32_t vertex) const {
  while (vertex != none && vertices_[vertex].last_part != none) vertex = vertices_[vertex].last_part;
  return vertex;
}

std::uint32_t MtgGraph::add_entity(std::string_view mark, std::string_view label, std::uint32_t from,
                                   const Column* column) {
  const unsigned scale = scale_of_class(label);
  Vertex vertex{label, scale, none, none, none, no_number, no_number, no_number, no_number, no_number};
  if (mark.front() == '/') {
    vertex.complex = scale == 0 ? none : raised(from, scale - 1);
  } else {
    std::uint32_t sibling = raised(from, scale);
    if (sibling == none || vertices_[sibling].scale != scale) {
      // An axis goes on after a branch that was written in its own column.
      const bool goes_on = column != nullptr && column->of_scale.contains(scale);
      if (!goes_on)
        throw source_.error(mark, fmt::format("'{}{}' after nothing of its scale", mark, excerpt(label)),
                            fmt::format("'{}' joins vertices of one scale", mark),
                            "use '/' for a part at a finer scale");
      sibling = from = column->of_scale.at(scale);
    }
    vertex.complex = vertices_[sibling].complex;
    vertex.anchor = deepest_part(from);
  }
  const auto number = static_cast<std::uint32_t>(vertices_.size());
  if (vertex.complex != none) vertices_[vertex.complex].last_part = number;
  vertices_.push_back(vertex);
  return number;
}

/// An entity that an absolute name repeats, or a new one.
std::uint32_t MtgGraph::named_entity(std::string_view mark, std::string_view label, std::uint32_t from,
                                     const Start& start, bool& is_old) {
  const std::tuple name{from, mark.front(), label};
  if (is_old)
    if (const auto found = named_.find(name); found != named_.end()) return found->second;
  is_old = false;
  const bool first_in_column = start.same_column && from == start.from;
  const std::uint32_t entity =
      add_entity(mark, label, from, first_in_column ? &columns_[start.column] : nullptr);
  named_[name] = entity;
  return entity;
}

MtgGraph::Start MtgGraph::start_of(std::string_view code, std::size_t column) {
  const bool same_column = code.starts_with('^');
  if (!same_column && column == 0) return {column, false, true, none};
  const std::size_t before = same_column ? column : column - 1;
  if (before >= columns_.size() || columns_[before].last == none)
    throw source_.error(code, fmt::format("'{}' goes on from nothing", excerpt(code)),
                        "no entity stands in the column it refers to", "move it to the left");
  return {column, same_column, false, columns_[before].last};
}

/// Adds the entities of a code, and keeps them as the last ones of its column.
std::uint32_t MtgGraph::add_code(std::string_view code, const Start& start) {
  const std::string_view whole = code;
  std::uint32_t current = start.from;
  bool is_old = start.absolute;
  std::vector<std::uint32_t> entities;
  if (start.same_column) code.remove_prefix(1);
  while (!code.empty()) {
    const std::string_view mark = code.substr(0, code.size() > 1 && code[0] == code[1] ? 2 : 1);
    const std::string_view rest = code.substr(mark.size());
    const auto end = std::ranges::find_if(rest, is_mark);
    const std::string_view label = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    if (!is_mark(mark.front()) || mark == "//" || label.empty())
      throw source_.error(code, fmt::format("'{}' is no entity", excerpt(code)),
                          "an entity is '/', '<' or '+' and a label", "write it like ^<S2");
    entities.push_back(current = named_entity(mark, label, current, start, is_old));
    code = rest.substr(label.size());
  }
  if (entities.empty())
    throw source_.error(whole, "'^' without an entity", "it only says where to go on", "write it like ^<S2");
  if (is_old) remarks_.ignore("row", "of an earlier date");
  columns_.resize(start.column + 1);
  if (!start.same_column) columns_.back() = {};
  columns_.back().last = current;
  for (const std::uint32_t entity : entities) columns_.back().of_scale[vertices_[entity].scale] = entity;
  return current;
}

/// A cell put in before the code of a branch moves its features to the right too: they are the last fields of
/// a line that has more of them than there are names. Where they are no numbers then, the rest is no feature.
void MtgGraph::move_back(std::vector<std::string_view>& fields) {
  while (!fields.empty() && fields.back().empty()) fields.pop_back();
  if (fields.size() <= header_.columns) return;
  if (header_.columns == 0) return;
  const std::size_t more = fields.size() - header_.columns;
  const auto begin =
      fields.begin() + static_cast<std::ptrdiff_t>(std::min(header_.code_columns, fields.size()));
  const auto end = std::min(begin + static_cast<std::ptrdiff_t>(more), fields.end());
  const auto is_number = [&](std::optional<std::size_t> column) {
    if (!column) return true;
    const std::string_view field = fields[*column + more];
    return is_missing(field) || style_.real(field).has_value();
  };
  const bool are_moved = begin != end && std::all_of(begin, end, [](auto field) { return field.empty(); }) &&
                         is_number(header_.length) && is_number(header_.radius) &&
                         is_number(header_.diameter) && is_number(header_.x) && is_number(header_.y) &&
                         is_number(header_.z);
  if (!are_moved) return remarks_.ignore("field", "right of the features", more);
  remarks_.doubt(
      fmt::format("line {} has more fields than there are names: its features are the last of them",
                  source_.at(source_.offset(fields.back())).line));
  fields.erase(begin, end);
}

void MtgGraph::add_features(std::vector<std::string_view> fields, Vertex& vertex) {
  move_back(fields);
  // What is missing leaves what an earlier date has.
  const auto read = [&](std::optional<std::size_t> column, std::string_view name, double& value) {
    if (column && *column < fields.size() && !is_missing(fields[*column]))
      value = number_in(source_, style_, fields[*column], name);
  };
  double diameter = no_number;
  read(header_.length, "length", vertex.length);
  read(header_.radius, "radius", vertex.radius);
  read(header_.diameter, "diameter", diameter);
  read(header_.x, "x", vertex.x);
  read(header_.y, "y", vertex.y);
  read(header_.z, "z", vertex.z);
  if (!std::isnan(diameter)) vertex.radius = diameter / 2;
}

void MtgGraph::add_later(std::size_t column, const std::vector<std::string_view>& fields) {
  if (column >= columns_.size() || columns_[column].last == none)
    throw source_.error(fields[column], "'*' after nothing",
                        "it says that the last entity of its column is measured again",
                        "write it below that");
  remarks_.ignore("row", "of an earlier date");
  add_features(fields, vertices_[columns_[column].last]);
}

/// "^+A2": a mark, and a label of a class that is known.
bool MtgGraph::begins_with_entity(std::string_view code) const {
  if (code.starts_with('^')) code.remove_prefix(1);
  return code.size() > 1 && is_mark(code.front()) && known_scale(code.substr(1)) != nullptr;
}

/// A line whose columns for codes are empty: its features belong to nothing.
void MtgGraph::remark_no_code(const std::vector<std::string_view>& fields) {
  const auto field = std::ranges::find_if(fields, [](auto text) { return !text.empty(); });
  if (field == fields.end()) return;
  if (begins_with_entity(*field))
    throw source_.error(*field, fmt::format("the code '{}' right of the columns for codes", excerpt(*field)),
                        fmt::format("the line of column names leaves {} for them", header_.code_columns),
                        "move the names of the features to the right");
  remarks_.ignore("row", "without a code");
}

void MtgGraph::add_line(std::string_view line) {
  const auto fields = mtg_fields(line);
  const std::size_t width = std::min(header_.code_columns, fields.size());
  std::size_t column = 0;
  while (column < width && fields[column].empty()) ++column;
  if (column == width) return remark_no_code(fields);
  if (fields[column] == "*") return add_later(column, fields);
  // A comment that goes on behind a tab.
  if (trimmed(line).starts_with('#') && !begins_with_entity(fields[column])) return remark_no_code(fields);
  std::uint32_t entity = add_code(fields[column], start_of(fields[column], column));
  // A code may spread over cells: each goes on from the one to its left.
  while (++column < width) {
    if (begins_with_entity(fields[column])) {
      entity = add_code(fields[column], start_of(fields[column], column));
    } else if (!fields[column].empty()) {
      remarks_.ignore("field", "right of the code");
    }
  }
  add_features(fields, vertices_[entity]);
}

bool MtgGraph::is_node(std::uint32_t vertex, unsigned scale) const {
  const Vertex& it = vertices_[vertex];
  return scale == 0 ? it.last_part == none : it.scale == scale;
}

/// What a vertex, or the nearest of its complexes that says so, follows or branches from.
std::uint32_t MtgGraph::next_anchor(std::uint32_t vertex) const {
  while (vertex != none && vertices_[vertex].anchor == none) vertex = vertices_[vertex].complex;
  return vertex == none ? none : vertices_[vertex].anchor;
}

std::uint32_t MtgGraph::parent(std::uint32_t vertex, unsigned scale) const {
  std::uint32_t anchor = next_anchor(vertex);
  while (anchor != none) {
    anchor = scale == 0 ? deepest_part(anchor) : raised(anchor, scale);
    if (anchor == none || is_node(anchor, scale)) return anchor;
    anchor = next_anchor(anchor);
  }
  return none;
}

}  // namespace ramify::detail
