#pragma once

#include <cstddef>
#include <string>

namespace ramify::detail {

/// How many filters, and values of one, the tables of a page have.
struct FilterReach {
  std::size_t filters = 0, values = 0;
};

/// The class of what has a value of a filter, its choice and the rows: "f0v2". Values count from 1; 0 is all.
std::string filter_class(std::size_t filter, std::size_t value);

/// The style sheet of a page. A filter is a rule: where the choice of a value is checked, rows without its
/// class are not shown. Browsers that do not know :has() show no filters.
std::string page_style(const FilterReach& reach);

}  // namespace ramify::detail
