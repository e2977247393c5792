#pragma once

#include "ramify/io/table.hpp"

namespace ramify {

/// The table as a person wants to see it: without columns that are empty in every row, and of summaries the
/// first five digits. What is exact (Row::exact) keeps ten. A machine wants the table itself.
Table readable(const Table& table);

}  // namespace ramify
