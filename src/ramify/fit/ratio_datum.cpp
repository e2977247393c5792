#include "ramify/fit/ratio_datum.hpp"

#include <algorithm>
#include <cmath>

#include "ramify/fit/ratio_table.hpp"
#include "ramify/format/order_counts.hpp"
#include "ramify/statistic/horton_law.hpp"
#include "ramify/text/header_fields.hpp"
#include "ramify/text/text_file.hpp"

namespace ramify {
namespace {

/// A header with orders, or counts, and no ratios is that of a table of counts which lacks the other.
bool is_half_order_table(const CsvData& table) {
  return !table.column("ratio") && (table.column("order") || table.column("count"));
}

}  // namespace

std::vector<RatioDatum> read_ratio_data(const std::filesystem::path& path) {
  return parse_ratio_data(read_text_file(path), path.string());
}

bool is_ratio_table(std::string_view text) {
  return std::ranges::any_of(header_fields(text), [](std::string_view field) {
    return field == "ratio" || field == "order" || field == "count";
  });
}

std::vector<RatioDatum> parse_ratio_data(std::string_view text, std::string_view name) {
  if (is_order_table(text)) return parse_order_table(SourceText(text, name));
  const CsvData table = CsvData::parse(text, name);
  if (is_half_order_table(table)) return parse_order_table(SourceText(text, name));
  return parse_ratio_table(table);
}

Size whole_horton_size(double ratio, std::uint64_t orders) {
  const double size = std::round(horton_size(ratio, static_cast<double>(orders)));
  return size < static_cast<double>(max_size) ? static_cast<Size>(size) : max_size;
}

}  // namespace ramify
