#include "ramify/fit/ratio_datum.hpp"

#include <cmath>

#include "ramify/fit/ratio_table.hpp"
#include "ramify/statistic/horton_law.hpp"

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

Size whole_horton_size(double ratio, std::uint64_t orders) {
  const double size = std::round(horton_size(ratio, static_cast<double>(orders)));
  return size < static_cast<double>(max_size) ? static_cast<Size>(size) : max_size;
}

}  // namespace ramify
