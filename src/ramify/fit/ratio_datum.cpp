#include "ramify/fit/ratio_datum.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/fit/ratio_table.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {
namespace {

std::vector<RatioDatum> parse_either(const CsvData& table) {
  if (table.column("order") || table.column("count")) return {parse_order_table(table)};
  return parse_ratio_table(table);
}

}  // namespace

std::vector<RatioDatum> read_ratio_data(const std::filesystem::path& path) {
  return parse_either(CsvData::read(path));
}

std::vector<RatioDatum> parse_ratio_data(std::string_view text, std::string_view name) {
  return parse_either(CsvData::parse(text, name));
}

Size horton_size(double ratio, std::uint64_t orders) {
  const double size = std::round((std::pow(ratio, static_cast<double>(orders)) - 1) / (ratio - 1));
  return size < static_cast<double>(max_size) ? static_cast<Size>(size) : max_size;
}

void require_known_columns(const CsvData& table, const std::vector<std::string>& known) {
  for (const std::string& column : table.header()) {
    if (std::find(known.begin(), known.end(), column) != known.end()) continue;
    throw error_at({table.name(), 0, 0}, fmt::format("unknown column '{}'", column),
                   "a column that is not read would be passed over in silence",
                   fmt::format("{}known are {}", did_you_mean(column, known), fmt::join(known, ", ")));
  }
}

}  // namespace ramify
