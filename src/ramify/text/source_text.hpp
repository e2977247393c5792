#pragma once

#include <string>
#include <string_view>

#include "ramify/core/error.hpp"

namespace ramify {

/// A text that was read, and the name it goes by in messages. Places in it are byte offsets; line and column
/// are counted where an error needs them, not before.
class SourceText {
 public:
  /// @param name  a file name; both must outlive the SourceText
  /// A byte-order mark at the start is left out.
  SourceText(std::string_view text, std::string_view name);

  std::string_view text() const { return text_; }
  std::string_view name() const { return name_; }

  /// Line and column of a byte: lines end in `\n`, `\r\n` or `\r`; columns count characters of UTF-8.
  /// O(offset).
  SourceLocation at(std::size_t offset) const;

  /// The offset of a part of the text.
  std::size_t offset(std::string_view part) const;

  /// "name:line:column: problem (why): remedy".
  Error error(std::size_t offset, std::string_view problem, std::string_view why,
              std::string_view remedy) const;
  Error error(std::string_view part, std::string_view problem, std::string_view why,
              std::string_view remedy) const;

 private:
  std::string_view text_;
  std::string_view name_;
};

/// At most 40 bytes of a text, for messages: what was cut off is marked by dots.
std::string excerpt(std::string_view text);

}  // namespace ramify
