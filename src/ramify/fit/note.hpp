#pragma once

#include <string>
#include <string_view>

namespace ramify {

/// What a row of a fit is told besides its numbers: one more clause, after "; ". Nothing is added by nothing.
inline void add_note(std::string& note, std::string_view text) {
  if (text.empty()) return;
  if (!note.empty()) note.append("; ");
  note.append(text);
}

}  // namespace ramify
