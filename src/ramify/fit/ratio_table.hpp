#pragma once

#include <vector>

#include "ramify/fit/ratio_datum.hpp"
#include "ramify/text/csv_reader.hpp"
#include "ramify/text/source_text.hpp"

namespace ramify {

/// The data of a table of published ratios, one a row. Throws Error.
std::vector<RatioDatum> parse_ratio_table(const CsvData& table);

/// The data of a table of stream counts, one a tree: R = mean ratio, n = N_1 - 1. Throws Error.
std::vector<RatioDatum> parse_order_table(SourceText source);

}  // namespace ramify
