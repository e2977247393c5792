#include "ramify/page/html_table.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ramify/core/contract.hpp"
#include "ramify/page/html_writer.hpp"

namespace ramify::detail {
namespace {

std::size_t place_of(const Table& table, const std::string& column) {
  const auto place = std::ranges::find(table.columns(), column);
  RAMIFY_EXPECTS(place != table.columns().end());
  return static_cast<std::size_t>(place - table.columns().begin());
}

/// Numbers stand at the right; sentences have room; a few words stay in one line.
std::string kind_of(const Table& table, std::size_t column) {
  if (table.holds_numbers(column)) return " class=\"number\"";
  constexpr std::size_t sentence = 36, words = 16;
  std::size_t longest = 0;
  for (std::size_t r = 0; r < table.rows(); ++r)
    longest = std::max(longest, to_text(table.row(r)[column]).size());
  return longest > sentence ? " class=\"long\"" : longest > 0 && longest <= words ? " class=\"short\"" : "";
}

std::string_view class_of(PageTone tone) {
  switch (tone) {
    case PageTone::good:
      return " good";
    case PageTone::bad:
      return " bad";
    case PageTone::open:
      return " open";
    case PageTone::plain:
      break;
  }
  return "";
}

std::string choice(std::string_view group, std::string_view kind, std::string_view label, std::size_t rows,
                   bool checked) {
  return fmt::format("<label><input type=\"radio\" name=\"{}\" class=\"{}\"{}> {} ({})</label>\n", group,
                     kind, checked ? " checked" : "", html_text(label), rows);
}

}  // namespace

HtmlTable::HtmlTable(const PageTable& table, int number) : table_(table), number_(number) {
  RAMIFY_EXPECTS(table.links.empty() || table.links.size() == table.table.rows());
  RAMIFY_EXPECTS(table.badges.tones.empty() || table.badges.tones.size() == table.table.rows());
  for (std::size_t c = 0; c < table.table.columns().size(); ++c) kinds_.push_back(kind_of(table.table, c));
  for (const std::string& column : table.filters) add_filter(place_of(table.table, column));
}

std::string HtmlTable::field_text(std::size_t row, std::size_t column) const {
  return to_text(table_.table.row(row)[column]);
}

void HtmlTable::add_filter(std::size_t column) {
  Filter filter{column, {}, {}};
  for (std::size_t r = 0; r < table_.table.rows(); ++r) {
    const std::string value = field_text(r, column);
    const auto place = std::ranges::find(filter.values, value);
    const auto index = static_cast<std::size_t>(place - filter.values.begin());
    if (place == filter.values.end()) {
      filter.values.push_back(value);
      filter.rows.push_back(0);
    }
    ++filter.rows[index];
  }
  filters_.push_back(std::move(filter));
}

FilterReach HtmlTable::reach() const {
  FilterReach reach{filters_.size(), 0};
  for (const Filter& filter : filters_) reach.values = std::max(reach.values, filter.values.size());
  return reach;
}

std::string HtmlTable::filters() const {
  std::string text = "<div class=\"filters\">\n";
  for (std::size_t f = 0; f < filters_.size(); ++f) {
    const std::string group = fmt::format("table{}-{}", number_, f);
    text += fmt::format("<fieldset>\n<legend>{}</legend>\n",
                        html_text(table_.table.columns()[filters_[f].column])) +
            choice(group, filter_class(f, 0), "all", table_.table.rows(), true);
    for (std::size_t v = 0; v < filters_[f].values.size(); ++v)
      text += choice(group, filter_class(f, v + 1), filters_[f].values[v], filters_[f].rows[v], false);
    text += "</fieldset>\n";
  }
  return text + "</div>\n";
}

std::string HtmlTable::head() const {
  std::string text = "<thead><tr>";
  for (std::size_t c = 0; c < kinds_.size(); ++c)
    text += fmt::format("<th scope=\"col\"{}>{}</th>", kinds_[c], html_text(table_.table.columns()[c]));
  return text + "</tr></thead>\n";
}

std::string HtmlTable::field(std::size_t row, std::size_t column) const {
  std::string text = html_text(field_text(row, column));
  if (column == 0 && !table_.links.empty() && !table_.links[row].empty())
    return fmt::format("<a href=\"#{}\">{}</a>", html_text(table_.links[row]), text);
  if (!table_.badges.tones.empty() && table_.table.columns()[column] == table_.badges.column)
    return fmt::format("<span class=\"badge{}\">{}</span>", class_of(table_.badges.tones[row]), text);
  return text;
}

std::string HtmlTable::row(std::size_t row) const {
  std::vector<std::string> classes;
  for (std::size_t f = 0; f < filters_.size(); ++f) {
    const auto place = std::ranges::find(filters_[f].values, field_text(row, filters_[f].column));
    classes.push_back(filter_class(f, 1 + static_cast<std::size_t>(place - filters_[f].values.begin())));
  }
  std::string text = classes.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", fmt::join(classes, " "));
  for (std::size_t c = 0; c < kinds_.size(); ++c)
    text += fmt::format("<td{}>{}</td>", kinds_[c], field(row, c));
  return text + "</tr>\n";
}

std::string HtmlTable::text() const {
  std::string text = filters_.empty() ? "" : "<div class=\"filtered\">\n" + filters();
  text += wide_box(table_.caption) +
          fmt::format("<table>\n<caption>{}</caption>\n", html_text(table_.caption)) + head() + "<tbody>\n";
  for (std::size_t r = 0; r < table_.table.rows(); ++r) text += row(r);
  text += "</tbody>\n</table>\n</div>\n";
  return filters_.empty() ? text : text + "</div>\n";
}

std::string wide_box(std::string_view label) {
  return fmt::format("<div class=\"wide\" role=\"group\" tabindex=\"0\" aria-label=\"{}\">\n",
                     html_text(label));
}

}  // namespace ramify::detail
