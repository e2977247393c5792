#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace ramify {

/// Goes through a text line by line; lines end in `\n`, `\r\n` or `\r`, and the last one need not.
class LineCursor {
 public:
  explicit LineCursor(std::string_view text) : text_(text) {}

  /// Steps to the next line; false after the last.
  bool next() {
    if (begin_ >= text_.size()) return false;
    const std::size_t end = std::min(next_of('\n', line_feed_), next_of('\r', carriage_return_));
    line_ = text_.substr(begin_, end - begin_);
    begin_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
    ++number_;
    return true;
  }

  /// The line without its end.
  std::string_view line() const { return line_; }
  /// From 1.
  std::size_t number() const { return number_; }

 private:
  /// The next place of either end of a line, searched once: find is many times as fast as find_first_of.
  std::size_t next_of(char end, std::size_t& known) const {
    if (known == unknown || known < begin_) known = std::min(text_.find(end, begin_), text_.size());
    return known;
  }

  std::string_view text_;
  std::string_view line_;
  std::size_t begin_ = 0;
  static constexpr std::size_t unknown = std::string_view::npos;
  std::size_t line_feed_ = unknown, carriage_return_ = unknown;
  std::size_t number_ = 0;
};

}  // namespace ramify
