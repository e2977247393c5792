#include "ramify/text/known_columns.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/nearest_name.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {

void require_known_columns(const CsvData& table, const std::vector<std::string>& known) {
  for (const std::string& column : table.header()) {
    if (std::find(known.begin(), known.end(), column) != known.end()) continue;
    throw error_at({table.name(), 0, 0}, fmt::format("unknown column '{}'", column),
                   "a column that is not read would be passed over in silence",
                   fmt::format("{}known are {}", did_you_mean(column, known), fmt::join(known, ", ")));
  }
}

}  // namespace ramify
