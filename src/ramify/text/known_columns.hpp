#pragma once

#include <string>
#include <vector>

#include "ramify/text/csv_reader.hpp"

namespace ramify {

/// Throws Error for a column that is not among the known ones, naming the nearest.
void require_known_columns(const CsvData& table, const std::vector<std::string>& known);

}  // namespace ramify
