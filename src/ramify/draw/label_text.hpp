#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ramify {

/// A name as a label: UTF-8, control characters as blanks, bytes that are no UTF-8 as question marks, cut to
/// the longest with an ellipsis.
std::string label_text(std::string_view name, std::size_t longest = 40);

}  // namespace ramify
