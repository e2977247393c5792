#include "ramify/text/header_fields.hpp"

#include "ramify/text/line_cursor.hpp"
#include "ramify/text/trimmed.hpp"

namespace ramify {

std::vector<std::string_view> header_fields(std::string_view text) {
  LineCursor lines(text);
  do {
    if (!lines.next()) return {};
  } while (lines.line().empty() || lines.line().starts_with('#'));
  std::vector<std::string_view> fields;
  for (std::string_view rest = lines.line();;) {
    const std::size_t comma = rest.find(',');
    fields.push_back(trimmed(rest.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace ramify
