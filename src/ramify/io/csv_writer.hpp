#pragma once

#include <string>

#include "ramify/io/table.hpp"

namespace ramify {

/// The table as CSV (RFC 4180): the names of the columns, then its rows. Quotes only where a field needs them
/// ("beta(10,80)"), lines end in \n.
std::string write_csv(const Table& table);

}  // namespace ramify
