#include "ramify/format/mtg_graph.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"

namespace ramify::detail {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

bool is_mark(char c) {
  return c == '/' || c == '<' || c == '+';
}

}  // namespace

unsigned MtgGraph::scale_of_class(std::string_view label) const {
  // The longest class name that the label begins with: "S12" is of class S unless there is one called S1.
  for (std::size_t size = label.size(); size > 0; --size) {
    const auto found = header_.scales.find(label.substr(0, size));
    if (found != header_.scales.end() && found->second > 0) return found->second;
  }
  throw source_.error(label, fmt::format("entity '{}' of no class", excerpt(label)),
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

std::uint32_t MtgGraph::add_entity(std::string_view mark, std::string_view label, std::uint32_t from) {
  const unsigned scale = scale_of_class(label);
  Vertex vertex{label, scale, none, none, none, no_number, no_number, no_number, no_number, no_number};
  if (mark.front() == '/') {
    vertex.complex = raised(from, scale - 1);
  } else {
    const std::uint32_t sibling = raised(from, scale);
    if (sibling == none || vertices_[sibling].scale != scale)
      throw source_.error(mark, fmt::format("'{}{}' after nothing of its scale", mark, excerpt(label)),
                          fmt::format("'{}' joins vertices of one scale", mark),
                          "use '/' for a part at a finer scale");
    vertex.complex = vertices_[sibling].complex;
    vertex.anchor = deepest_part(from);
  }
  const auto number = static_cast<std::uint32_t>(vertices_.size());
  if (vertex.complex != none) vertices_[vertex.complex].last_part = number;
  vertices_.push_back(vertex);
  return number;
}

void MtgGraph::add_features(const std::vector<std::string_view>& fields, Vertex& vertex) const {
  const auto read = [&](std::optional<std::size_t> column, std::string_view name, double& value) {
    if (column && *column < fields.size()) value = number_or_none(source_, fields[*column], name);
  };
  double diameter = no_number;
  read(header_.length, "length", vertex.length);
  read(header_.radius, "radius", vertex.radius);
  read(header_.diameter, "diameter", diameter);
  read(header_.x, "x", vertex.x);
  read(header_.y, "y", vertex.y);
  read(header_.z, "z", vertex.z);
  if (!header_.radius) vertex.radius = diameter / 2;
}

void MtgGraph::add_line(std::string_view line) {
  const auto fields = mtg_fields(line);
  const std::size_t width = std::min(header_.code_columns, fields.size());
  std::size_t column = 0;
  while (column < width && fields[column].empty()) ++column;
  if (column == width) return;
  std::string_view code = fields[column];
  const bool same_column = code.starts_with('^');
  const std::size_t before = same_column ? column : column - 1;
  if ((same_column || column > 0) && before >= last_.size())
    throw source_.error(code, fmt::format("'{}' goes on from nothing", excerpt(code)),
                        "no entity stands in the column it refers to", "move it to the left");
  std::uint32_t current = !same_column && column == 0 ? none : last_[before];
  if (same_column) code.remove_prefix(1);
  while (!code.empty()) {
    const std::string_view mark = code.substr(0, code.size() > 1 && code[0] == code[1] ? 2 : 1);
    const std::string_view rest = code.substr(mark.size());
    const auto end = std::ranges::find_if(rest, is_mark);
    const std::string_view label = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    if (!is_mark(mark.front()) || mark == "//" || label.empty())
      throw source_.error(code, fmt::format("'{}' is no entity", excerpt(code)),
                          "an entity is '/', '<' or '+' and a label", "write it like ^<S2");
    current = add_entity(mark, label, current);
    code = rest.substr(label.size());
  }
  if (current == none)
    throw source_.error(fields[column], "'^' without an entity", "it only says where to go on",
                        "write it like ^<S2");
  add_features(fields, vertices_[current]);
  last_.resize(column, none);
  last_.push_back(current);
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
