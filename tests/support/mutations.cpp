#include "support/mutations.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace ramify::test {
namespace {

bool is_whole(const std::string& field) {
  const std::size_t first = field.starts_with('-') ? 1 : 0;
  return field.size() > first && field.find_first_not_of("0123456789", first) == std::string::npos;
}

bool is_real(const std::string& field) {
  return !is_whole(field) && std::ranges::count(field, '.') == 1 &&
         field.find_first_not_of("0123456789-.") == std::string::npos;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cut(const std::string& line, const std::string& separators, bool runs) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (separators.find(c) == std::string::npos) {
      fields.back() += c;
    } else if (!runs || !fields.back().empty()) {
      fields.emplace_back();
    }
  }
  if (runs && fields.back().empty()) fields.pop_back();
  return fields;
}

}  // namespace

std::string Mutator::whole(const std::string& number) {
  const bool negative = number.starts_with('-');
  const std::string digits = number.substr(negative ? 1 : 0), sign = negative ? "-" : "";
  switch (below(8)) {
    case 0:
      return sign + digits + ".0";
    case 1:
      return sign + "0" + digits;
    case 2:
      return sign + digits + "e+00";
    case 3:
      return sign + digits + ".000000";
    case 4:
      return negative ? number : "+" + digits;
    default:
      return number;
  }
}

std::string Mutator::real(const std::string& number, char decimal) {
  std::string text = number;
  const std::size_t point = text.find('.');
  if (point == std::string::npos) return whole(text);
  switch (below(5)) {
    case 0:
      text += "0";
      break;
    case 1:
      text += "e0";
      break;
    case 2:
      if (text.starts_with("0.")) text.erase(0, 1);
      break;
    default:
      break;
  }
  std::ranges::replace(text, '.', decimal);
  return text;
}

std::string Mutator::missing() {
  const char* const words[] = {"", "NA", "<NA>", "N/A", "-1", "-1.0", "nan", "None"};
  return words[below(std::size(words))];
}

std::string Mutator::with_line_ends(const std::string& text) {
  const char* const ends[] = {"\n", "\r\n", "\r"};
  const std::string end = ends[below(3)];
  std::string changed = maybe(0.2) ? "\xEF\xBB\xBF" : "";
  for (const char c : text) changed += c == '\n' ? end : std::string(1, c);
  if (maybe(0.3) && changed.ends_with(end)) changed.resize(changed.size() - end.size());
  return changed;
}

std::string Mutator::joined(const Rows& rows, char separator, double quotes) {
  std::string text;
  const bool blanks_around = separator != ' ' && maybe(0.3);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += separator;
      if (blanks_around && maybe(0.3)) text += ' ';
      text += maybe(quotes) || (row[i].empty() && separator == ' ') ? '"' + row[i] + '"' : row[i];
      if (blanks_around && maybe(0.3)) text += ' ';
    }
    text += '\n';
  }
  return text;
}

std::string Mutator::table(const std::string& text, bool has_header) {
  Rows rows;
  for (const std::string& line : lines_of(text))
    if (!line.empty() && line[0] != '#') rows.push_back(cut(line, has_header ? "," : "\t", false));
  const char separators[] = {',', ';', '\t', ' '};
  const char separator = separators[below(4)];
  const char decimal = separator != ',' && maybe(0.5) ? ',' : '.';
  std::vector<std::size_t> order(rows[0].size());
  std::iota(order.begin(), order.end(), 0);
  if (has_header) std::ranges::shuffle(order, random_);
  Rows changed;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    changed.emplace_back();
    for (const std::size_t column : order) {
      std::string field = rows[i][column];
      if (i > 0 || !has_header) {
        const std::string& name = has_header ? rows[0][column] : field;
        if (name == "parent" && field.empty()) field = missing();
        if (is_whole(field)) field = whole(field);
        if (is_real(field)) field = real(field, decimal);
        if (is_whole(rows[i][column])) std::ranges::replace(field, '.', decimal);
      }
      changed.back().push_back(field);
    }
  }
  std::string written = joined(changed, separator, maybe(0.5) ? 0.3 : 0);
  if (has_header && maybe(0.2)) written = "# a comment\n\n" + written;
  return with_line_ends(written);
}

std::string Mutator::points(const std::string& text) {
  const char* const separators[] = {" ", "\t", "  ", ",", "\t ", ";"};
  const std::string separator = separators[below(6)];
  const bool decimal_commas = separator != "," && maybe(0.5);
  std::string changed;
  for (const std::string& line : lines_of(text)) {
    if (line.empty() || line[0] == '#') {
      changed += line + '\n';
      continue;
    }
    if (maybe(0.1)) changed += "# between\n";
    if (maybe(0.2)) changed += "  ";
    const auto fields = cut(line, " \t", true);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i > 0) changed += separator;
      std::string field = is_whole(fields[i]) ? whole(fields[i]) : real(fields[i], '.');
      if (decimal_commas) std::ranges::replace(field, '.', ',');
      changed += field;
    }
    if (maybe(0.1)) changed += " # behind";
    changed += '\n';
  }
  return with_line_ends(changed);
}

std::string Mutator::newick(const std::string& text) {
  std::string changed;
  bool in_length = false;
  std::string number;
  for (const char c : text) {
    if (in_length && (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.')) {
      number += c;
      continue;
    }
    if (in_length && !number.empty()) {
      changed += is_whole(number) ? whole(number) : real(number, '.');
      number.clear();
    }
    in_length = c == ':';
    changed += c;
    const bool may_break = c == '(' || c == ',' || c == ':';
    if (may_break && maybe(0.1)) changed += maybe(0.5) ? "\n" : " ";
    if (may_break && maybe(0.1)) changed += "[a comment]";
  }
  return with_line_ends(changed);
}

std::string Mutator::mtg(const std::string& text) {
  std::string changed;
  bool in_entities = false;
  const char decimal = maybe(0.3) ? ',' : '.';
  for (const std::string& line : lines_of(text)) {
    if (maybe(0.1)) changed += maybe(0.5) ? "# a comment\n" : "\n";
    const auto fields = cut(line, "\t", false);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      std::string field = fields[i];
      if (in_entities && is_whole(field)) field = whole(field);
      if (in_entities && is_real(field)) field = real(field, decimal);
      if (in_entities && !fields[i].empty() && is_whole(fields[i])) std::ranges::replace(field, '.', decimal);
      const bool is_code = field.find_first_of("/+<") != std::string::npos;
      if (in_entities && is_code && maybe(0.1)) field += "#cut";
      changed += (i > 0 ? "\t" : "") + field;
    }
    changed += '\n';
    in_entities = in_entities || line.starts_with("ENTITY-CODE") || line.starts_with("TOPO");
  }
  return with_line_ends(changed);
}

std::string Mutator::mutated(const std::string& name, const std::string& text) {
  if (name.ends_with(".newick")) return newick(text);
  if (name.ends_with(".swc")) return points(text);
  if (name.ends_with(".mtg")) return mtg(text);
  return table(text, name.ends_with(".csv"));
}

}  // namespace ramify::test
