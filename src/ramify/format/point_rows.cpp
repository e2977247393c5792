#include "ramify/format/point_rows.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ramify/format/delimited_rows.hpp"
#include "ramify/format/table_layout.hpp"
#include "ramify/text/whole_number.hpp"

namespace ramify::detail {
namespace {

constexpr std::size_t swc_fields = 7;

/// "id type x y z radius parent".
TableColumns swc_columns() {
  TableColumns columns;
  columns.id = 0;
  columns.type = 1;
  columns.x = 2;
  columns.y = 3;
  columns.z = 4;
  columns.radius = 5;
  columns.parent = 6;
  return columns;
}

std::string_view checked_id(const SourceText& source, std::string_view field) {
  if (!whole_number(field))
    throw source.error(field, fmt::format("id '{}'", excerpt(field)), "ids are whole numbers",
                       "write the seven columns id type x y z radius parent");
  return field;
}

/// Numbers of SWC, or their names.
int type_of(std::string_view field) {
  if (const auto number = whole_number(field)) {
    int type = 0;
    std::from_chars(number->data(), number->data() + number->size(), type);
    return type;
  }
  constexpr std::array<std::string_view, 5> words{"undefined", "soma", "axon", "dendrite", "apical"};
  std::string lower;
  for (const char c : field) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto found = std::ranges::find(words, lower);
  return found == words.end() ? 0 : static_cast<int>(found - words.begin());
}

class PointReader {
 public:
  PointReader(const SourceText& source, const TableColumns& columns, NumberStyle style, Remarks& remarks)
      : source_(source), columns_(columns), style_(style), remarks_(remarks) {}

  void remark() const {
    if (unknown_radii_ > 0)
      remarks_.doubt(
          fmt::format("{} without a radius (-1 or none)",
                      unknown_radii_ == 1 ? "a point is" : fmt::format("{} points are", unknown_radii_)));
  }

  Point read(const std::vector<std::string_view>& fields) {
    Point point;
    point.id = checked_id(source_, fields[*columns_.id]);
    point.parent = fields[*columns_.parent];
    if (is_missing(point.parent) || whole_number(point.parent) == "-1") {
      point.parent = point.parent.substr(0, 0);
    } else {
      checked_id(source_, point.parent);
    }
    if (columns_.type) point.type = type_of(fields[*columns_.type]);
    point.x = number_in(source_, style_, fields[*columns_.x], "x");
    point.y = number_in(source_, style_, fields[*columns_.y], "y");
    point.z = number_in(source_, style_, fields[*columns_.z], "z");
    point.radius = radius_of(fields);
    return point;
  }

 private:
  /// -1 is what some programs write for none.
  double radius_of(const std::vector<std::string_view>& fields) {
    const auto column = columns_.radius ? columns_.radius : columns_.diameter;
    if (!column) return std::numeric_limits<double>::quiet_NaN();
    const std::string_view field = fields[*column];
    const double radius = number_or_none(source_, style_, field, "radius");
    if (radius == -1 || std::isnan(radius)) {
      ++unknown_radii_;
      return std::numeric_limits<double>::quiet_NaN();
    }
    if (radius < 0)
      throw source_.error(field, fmt::format("radius {}", field), "it is not negative", "correct it");
    return columns_.radius ? radius : radius / 2;
  }

  const SourceText& source_;
  TableColumns columns_;
  NumberStyle style_;
  Remarks& remarks_;
  std::size_t unknown_radii_ = 0;
};

std::vector<std::optional<std::size_t>> numbers_of(const TableColumns& columns) {
  return {columns.x, columns.y, columns.z, columns.radius, columns.diameter};
}

/// Where two columns may hold the type, it is the one whose first entry says one.
void choose_type(TableColumns& columns, const std::vector<std::string_view>& fields) {
  if (columns.type && columns.name && type_of(fields[*columns.type]) == 0 &&
      whole_number(fields[*columns.name]))
    std::swap(columns.type, columns.name);
  columns.name.reset();
}

std::vector<Point> read_table(DelimitedRows& rows, Remarks& remarks) {
  TableLayout layout = layout_below_header(rows, &point_columns);
  choose_type(layout.columns, rows.fields());
  PointReader reader(rows.source(), layout.columns, style_of(rows, numbers_of(layout.columns)), remarks);
  std::vector<Point> points;
  do {
    require_fields(rows, layout.header.size());
    points.push_back(reader.read(rows.fields()));
  } while (rows.next());
  reader.remark();
  remark_ignored(layout, remarks);
  return points;
}

void require_point(const DelimitedRows& rows, std::size_t least) {
  const auto& fields = rows.fields();
  if (fields.size() >= least) return;
  throw rows.source().error(fields.back(), fmt::format("a line of {} field(s)", fields.size()),
                            "a point has seven: id type x y z radius parent",
                            "restore what was cut off, or put # before a comment");
}

}  // namespace

double distance(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

bool is_point_row(const std::vector<std::string_view>& fields) {
  if (fields.size() < swc_fields || !whole_number(fields[0])) return false;
  const std::string_view parent = fields[swc_fields - 1];
  if (!whole_number(parent) && !is_missing(parent)) return false;
  return std::ranges::all_of(fields.begin(), fields.begin() + swc_fields - 1, [](std::string_view field) {
    return is_missing(field) || field.find_first_not_of("0123456789+-.,eE") == std::string_view::npos;
  });
}

std::vector<Point> read_points(const SourceText& source, Remarks& remarks) {
  DelimitedRows table(source);
  if (table.next() && point_columns(table.fields())) return read_table(table, remarks);
  DelimitedRows rows(source, DelimitedRows::Separator::points);
  std::vector<Point> points;
  if (!rows.next()) return points;
  TableColumns columns = swc_columns();
  std::size_t least = swc_fields;
  // A header in a comment may give the columns another order.
  if (const auto named = point_columns(rows.commented_header());
      named && rows.commented_header().size() == rows.fields().size()) {
    columns = *named;
    columns.name.reset();
    least = rows.fields().size();
  }
  PointReader reader(source, columns, style_of(rows, numbers_of(columns)), remarks);
  do {
    require_point(rows, least);
    points.push_back(reader.read(rows.fields()));
    remarks.ignore("field", "after the seventh", rows.fields().size() - swc_fields);
  } while (rows.next());
  reader.remark();
  return points;
}

}  // namespace ramify::detail
