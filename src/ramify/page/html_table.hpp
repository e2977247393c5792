#pragma once

#include <string>
#include <vector>

#include "ramify/page/html_style.hpp"
#include "ramify/page/page.hpp"

namespace ramify::detail {

/// A table as HTML, with its filters before it.
class HtmlTable {
 public:
  /// @param number  of the table on its page: filters of two tables do not know of each other
  HtmlTable(const PageTable& table, int number);

  FilterReach reach() const;
  std::string text() const;

 private:
  /// A column that filters, and its values in the order in which they come.
  struct Filter {
    std::size_t column;
    std::vector<std::string> values;
    std::vector<std::size_t> rows;  ///< that have the value
  };

  std::string field_text(std::size_t row, std::size_t column) const;
  void add_filter(std::size_t column);
  std::string filters() const;
  std::string head() const;
  std::string row(std::size_t row) const;
  std::string field(std::size_t row, std::size_t column) const;

  const PageTable& table_;
  const int number_;
  std::vector<std::string> kinds_;  ///< of the columns: class attributes
  std::vector<Filter> filters_;
};

/// The start of a box that scrolls by itself where it is too wide, and that the keyboard reaches: a div,
/// which is still to be closed.
std::string wide_box(std::string_view label);

}  // namespace ramify::detail
