#include "ramify/format/table_columns.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace ramify {
namespace {

using Names = std::initializer_list<std::string_view>;

std::optional<std::size_t> find(const std::vector<std::string>& header, Names names) {
  for (const std::string_view name : names) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found != header.end()) return static_cast<std::size_t>(found - header.begin());
  }
  return std::nullopt;
}

std::vector<std::string> plain(const std::vector<std::string_view>& header) {
  std::vector<std::string> names;
  for (const std::string_view column : header) names.push_back(plain_column(column));
  return names;
}

/// What all kinds have beside their ids.
TableColumns common_columns(const std::vector<std::string>& header) {
  TableColumns columns;
  columns.tree = find(header, {"tree"});
  columns.length = find(header, {"length", "length_cyl", "lengthkm", "len", "reach_length"});
  columns.radius = find(header, {"radius", "radius_cyl"});
  columns.diameter = find(header, {"diameter", "diam", "width"});
  columns.name = find(header, {"name", "label", "gnis_name"});
  return columns;
}

}  // namespace

std::string plain_column(std::string_view column) {
  std::string name;
  for (const char c : column) name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array<std::string_view, 5> units{"_mm", "_cm", "_um", "_km", "_m"};
  for (const std::string_view unit : units)
    if (name.size() > unit.size() && name.ends_with(unit)) return name.substr(0, name.size() - unit.size());
  return name;
}

std::optional<TableColumns> flowline_columns(const std::vector<std::string_view>& header) {
  const auto names = plain(header);
  TableColumns columns = common_columns(names);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> pairs{{{"id", "toid"},
                                                                                 {"comid", "tocomid"},
                                                                                 {"comid", "toid"},
                                                                                 {"nhdplusid", "tonhdplusid"},
                                                                                 {"hyriv_id", "next_down"},
                                                                                 {"linkno", "dslinkno"},
                                                                                 {"id", "downstream"},
                                                                                 {"id", "downstream_id"},
                                                                                 {"hydroseq", "dnhydroseq"},
                                                                                 {"fromnode", "tonode"}}};
  for (const auto& [id, downstream] : pairs) {
    columns.id = find(names, {id});
    columns.parent = find(names, {downstream});
    columns.by_nodes = id == "fromnode";
    if (columns.id && columns.parent) return columns;
  }
  return std::nullopt;
}

std::optional<TableColumns> qsm_columns(const std::vector<std::string_view>& header) {
  const auto names = plain(header);
  TableColumns columns = common_columns(names);
  columns.id = find(names, {"id", "cyl_id", "cylinder_id"});
  columns.parent = find(names, {"parent", "parentid", "parent_id"});
  if (!columns.parent || !columns.length || !(columns.radius || columns.diameter)) return std::nullopt;
  if (!columns.id && !find(names, {"extension"})) return std::nullopt;
  return columns;
}

std::optional<TableColumns> edge_columns(const std::vector<std::string_view>& header) {
  const auto names = plain(header);
  TableColumns columns = common_columns(names);
  columns.parent = find(names, {"parent", "parentid", "parent_id"});
  columns.id = find(names, {"id", "node"});
  if (columns.parent && columns.id) return columns;
  columns.pairs = true;
  columns.id = find(names, {"child"});
  if (columns.parent && columns.id) return columns;
  columns.parent = find(names, {"from", "source"});
  columns.id = find(names, {"to", "target"});
  if (columns.parent && columns.id) return columns;
  return std::nullopt;
}

}  // namespace ramify
