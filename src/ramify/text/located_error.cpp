#include "ramify/text/located_error.hpp"

#include <fmt/format.h>

namespace ramify {

std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f)
      line += c;
    else
      line += fmt::format("\\x{:02x}", byte);
  }
  return line;
}

Error error_at(const SourceLocation& place, std::string_view problem, std::string_view why,
               std::string_view remedy) {
  return Error(one_line(fmt::format("{}{}", to_prefix(place), problem)), one_line(why), one_line(remedy));
}

Error located(const Error& error, const SourceLocation& place) {
  // what() is "problem (why): remedy"; Error joins the parts the same way, so any place where the text can be
  // cut into three gives it back unchanged.
  const std::string_view text = error.what();
  const auto open = text.find(" (");
  const auto close = text.find("): ", open);
  return error_at(place, text.substr(0, open), text.substr(open + 2, close - open - 2),
                  text.substr(close + 3));
}

}  // namespace ramify
