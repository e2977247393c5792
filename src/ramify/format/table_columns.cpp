#include "ramify/format/table_columns.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "ramify/text/trimmed.hpp"

namespace ramify {
namespace {

using Name = std::string_view;

// One place for all names. The programs that write them stand beside.
constexpr Name tree_names[]{"tree", "treeid", "treename"};
constexpr Name length_names[]{"length",        "len",          "lengthcyl",
                              "lengthkm",      "reachlength",  // NHDPlus, hydroloom, MERIT
                              "branchlength",                  // tidytree
                              "edgelength",                    // ape, phylobase
                              "segmentlength", "streamlength", "meanlength"};
constexpr Name radius_names[]{"radius", "radiuscyl", "r", "rad", "meanradius"};
constexpr Name diameter_names[]{"diameter", "diam", "dia", "width", "meandiameter"};
constexpr Name area_names[]{"area",      "meanarea",      "drainagearea", "meandrainagearea",
                            "basinarea", "catchmentarea", "catchment"};
constexpr Name name_names[]{"name", "label", "gnisname", "taxon"};
constexpr Name order_names[]{"order",         "strahler",    "strahlerorder", "strahlernumber",
                             "hortonorder",   "streamorder", "orderu",        "hortonstrahlerorder",
                             "hortonstrahler"};
constexpr Name count_names[]{"count",           "counts",      "number",    "streams",          "n",
                             "numberofstreams", "nstreams",    "streamnum", "numberofbranches", "numstreams",
                             "streamcount",     "branchcount", "branches",  "frequency"};
constexpr Name leaf_order_names[]{"leaforder"};

constexpr Name parent_names[]{"parent",           "parentid", "parentno", "parentnode",
                              "parentnodeid",                               // navis: parent_id; Neuroglancer
                              "parenttreenodeid",                           // CATMAID
                              "parentsample",     "pid",      "ancestor"};  // phylobase: ancestor
constexpr Name node_names[]{"id", "node", "nodeid", "nodeno"};
constexpr Name cylinder_names[]{"id", "cylid", "cylinderid"};
constexpr Name point_names[]{"id",     "nodeid",   "node",     "treenodeid",   "pointno", "point",
                             "sample", "sampleno", "sampleid", "samplenumber", "index",   "n"};
constexpr Name soma_type_names[]{"structure", "structureid", "structureidentifier", "swctype", "t",
                                 "type",      "tag",         "compartment"};
constexpr Name point_radius_names[]{"radius", "r", "rad"};
constexpr Name point_diameter_names[]{"diameter", "diam", "w"};  // nat: W
constexpr Name point_parent_names[]{
    "parent",           "parentid",     "p",          "pid", "parentno", "parentnodeid",
    "parenttreenodeid", "parentsample", "parentpoint"};

struct Pair {
  Name id, parent;
};
constexpr Pair downstream_pairs[]{
    {"id", "toid"},  // hydroloom, nextgen hydrofabric
    {"comid", "tocomid"},     {"comid", "toid"},        {"nhdplusid", "tonhdplusid"},
    {"comid", "nextdownid"},                             // MERIT Basins
    {"hyrivid", "nextdown"},                             // HydroRIVERS
    {"hybasid", "nextdown"},                             // HydroBASINS
    {"linkno", "dslinkno"},                              // TauDEM
    {"streamid", "dslinkno"}, {"stream", "nextstream"},  // GRASS r.stream.order
    {"cat", "nextstream"},    {"stream", "nextstr"},     // openSTARS
    {"reachid", "rchiddn"},                              // SWORD
    {"id", "downstream"},     {"id", "downstreamid"},   {"id", "nextdown"},
    {"segid", "tosegid"},     {"segid", "toseg"},       {"hydroseq", "dnhydroseq"},  // NHDPlus
    {"fromnode", "tonode"}};
constexpr Pair child_pairs[]{{"child", "parent"},
                             {"child", "parentid"},
                             {"childid", "parentid"},
                             {"descendant", "ancestor"},
                             {"to", "from"},
                             {"target", "source"},
                             {"v2", "v1"}};  // ape: as.data.frame(tree$edge)

std::optional<std::size_t> find(const std::vector<std::string>& header, std::span<const Name> names) {
  for (const Name name : names) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found != header.end()) return static_cast<std::size_t>(found - header.begin());
  }
  return std::nullopt;
}

std::optional<std::size_t> find(const std::vector<std::string>& header, Name name) {
  return find(header, std::span(&name, 1));
}

std::span<const Name> names_of(ColumnRole role) {
  switch (role) {
    case ColumnRole::tree:
      return tree_names;
    case ColumnRole::length:
      return length_names;
    case ColumnRole::area:
      return area_names;
    case ColumnRole::radius:
      return radius_names;
    case ColumnRole::diameter:
      return diameter_names;
    case ColumnRole::name:
      return name_names;
    case ColumnRole::order:
      return order_names;
    case ColumnRole::count:
      return count_names;
    case ColumnRole::leaf_order:
      break;
  }
  return leaf_order_names;
}

std::vector<std::string> plain(const std::vector<std::string_view>& header) {
  std::vector<std::string> names;
  for (const std::string_view column : header) names.push_back(plain_column(column));
  return names;
}

/// What all kinds have beside their ids.
TableColumns common_columns(const std::vector<std::string>& header) {
  TableColumns columns;
  columns.tree = find(header, tree_names);
  columns.length = find(header, length_names);
  columns.radius = find(header, radius_names);
  if (!columns.radius) columns.diameter = find(header, diameter_names);
  columns.name = find(header, name_names);
  return columns;
}

bool find_pair(const std::vector<std::string>& header, std::span<const Pair> pairs, TableColumns& columns) {
  for (const auto& [id, parent] : pairs) {
    columns.id = find(header, id);
    columns.parent = find(header, parent);
    columns.by_nodes = id == "fromnode";
    if (columns.id && columns.parent) return true;
  }
  return false;
}

/// "length (m)" without its unit.
std::string_view without_brackets(std::string_view column) {
  if (!column.ends_with(')') && !column.ends_with(']')) return column;
  const auto open = column.rfind(column.back() == ')' ? '(' : '[');
  const std::string_view before = trimmed(column.substr(0, open));
  return open == std::string_view::npos || before.empty() ? column : before;
}

}  // namespace

bool TableColumns::uses(std::size_t column) const {
  for (const auto& used : {tree, id, parent, length, radius, diameter, name, type, x, y, z})
    if (used == column) return true;
  return false;
}

std::string plain_column(std::string_view column) {
  std::string name;
  for (const char c : without_brackets(trimmed(column)))
    name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::string_view units[]{"mm", "cm", "um", "km", "m"};
  for (const std::string_view unit : units) {
    if (name.size() < unit.size() + 2 || !name.ends_with(unit)) continue;
    const char before = name[name.size() - unit.size() - 1];
    if (before != '_' && before != '.' && before != ' ') continue;
    name.resize(name.size() - unit.size() - 1);
    break;
  }
  std::erase_if(name, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x80 && (c < 'a' || c > 'z') && (c < '0' || c > '9');
  });
  return name;
}

std::optional<std::size_t> find_column(const std::vector<std::string>& plain_header, ColumnRole role) {
  return find(plain_header, names_of(role));
}

std::optional<TableColumns> flowline_columns(const std::vector<std::string_view>& header) {
  const auto names = plain(header);
  TableColumns columns = common_columns(names);
  if (!find_pair(names, downstream_pairs, columns)) return std::nullopt;
  return columns;
}

std::optional<TableColumns> qsm_columns(const std::vector<std::string_view>& header) {
  const auto names = plain(header);
  TableColumns columns = common_columns(names);
  columns.id = find(names, cylinder_names);
  columns.parent = find(names, parent_names);
  if (!columns.parent || !columns.length || !(columns.radius || columns.diameter)) return std::nullopt;
  if (!columns.id && !find(names, "extension")) return std::nullopt;
  return columns;
}

std::optional<TableColumns> point_columns(const std::vector<std::string_view>& header) {
  const auto names = plain(header);
  TableColumns columns;
  columns.tree = find(names, tree_names);
  columns.id = find(names, point_names);
  columns.parent = find(names, point_parent_names);
  columns.x = find(names, "x");
  columns.y = find(names, "y");
  columns.z = find(names, "z");
  if (!columns.id || !columns.parent || !columns.x || !columns.y || !columns.z) return std::nullopt;
  // navis has the types of SWC in `label`, and other words in `type`: which of two it is, the rows tell.
  columns.type = find(names, soma_type_names);
  columns.name = find(names, "label");
  if (!columns.type) std::swap(columns.type, columns.name);
  columns.radius = find(names, point_radius_names);
  if (!columns.radius) columns.diameter = find(names, point_diameter_names);
  if (!columns.type && find(names, length_names)) return std::nullopt;
  return columns;
}

std::optional<TableColumns> edge_columns(const std::vector<std::string_view>& header) {
  const auto names = plain(header);
  TableColumns columns = common_columns(names);
  columns.parent = find(names, parent_names);
  columns.id = find(names, node_names);
  if (columns.parent && columns.id) return columns;
  columns.pairs = true;
  if (find_pair(names, child_pairs, columns)) return columns;
  return std::nullopt;
}

}  // namespace ramify
