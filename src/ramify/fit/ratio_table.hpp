#pragma once

#include <vector>

#include "ramify/fit/ratio_datum.hpp"
#include "ramify/text/csv_reader.hpp"

namespace ramify {

/// The data of a table of published ratios, one a row. Throws Error.
std::vector<RatioDatum> parse_ratio_table(const CsvData& table);

/// The one datum of a table of stream counts: R = mean ratio, n = N_1 - 1. Throws Error.
RatioDatum parse_order_table(const CsvData& table);

}  // namespace ramify
