#include "ramify/text/source_text.hpp"

#include <algorithm>

#include "ramify/core/contract.hpp"
#include "ramify/core/utf8.hpp"
#include "ramify/text/located_error.hpp"

namespace ramify {

SourceText::SourceText(std::string_view text, std::string_view name) : text_(text), name_(name) {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
}

SourceLocation SourceText::at(std::size_t offset) const {
  SourceLocation place{std::string(name_), 1, 1};
  for (std::size_t i = 0; i < std::min(offset, text_.size()); ++i) {
    const char byte = text_[i];
    const bool ends_line = byte == '\n' || (byte == '\r' && (i + 1 == text_.size() || text_[i + 1] != '\n'));
    if (ends_line) {
      ++place.line;
      place.column = 1;
    } else if (begins_character(byte)) {
      ++place.column;
    }
  }
  return place;
}

std::size_t SourceText::offset(std::string_view part) const {
  RAMIFY_EXPECTS(part.data() >= text_.data() && part.data() <= text_.data() + text_.size());
  return static_cast<std::size_t>(part.data() - text_.data());
}

Error SourceText::error(std::size_t offset, std::string_view problem, std::string_view why,
                        std::string_view remedy) const {
  return error_at(at(offset), problem, why, remedy);
}

Error SourceText::error(std::string_view part, std::string_view problem, std::string_view why,
                        std::string_view remedy) const {
  return error(offset(part), problem, why, remedy);
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 40;
  if (text.size() <= most) return std::string(text);
  return std::string(text.substr(0, most)) + "...";
}

}  // namespace ramify
