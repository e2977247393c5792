#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace ramify {

/// The whole number that a field writes, as its digits alone ("-" in front below 0): "01", "+1", "1.0",
/// "1,0", "1e+00" and " 1 " all give "1", for programs that pass a table on write its whole numbers in all
/// these ways. Nothing where the field is no whole number, or one of more than 40 digits.
std::optional<std::string> whole_number(std::string_view field);

/// What programs write where they have no value: nothing, NA, `<NA>`, N/A, NaN, none, null, nil, in any case.
bool is_missing(std::string_view field);

/// Ids as they are compared: whole numbers by value, any other text as it is.
class IdKeys {
 public:
  /// A part of the text where that will do, else of this object's own. O(length).
  std::string_view operator()(std::string_view id);

 private:
  std::deque<std::string> own_;
};

}  // namespace ramify
