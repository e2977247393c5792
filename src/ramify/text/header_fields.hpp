#pragma once

#include <string_view>
#include <vector>

namespace ramify {

/// The names in the header of a CSV text, without the space around them: its first line that is neither empty
/// nor begins with #. None of an empty text. What the columns are called says what a file holds before
/// anything is read.
std::vector<std::string_view> header_fields(std::string_view text);

}  // namespace ramify
