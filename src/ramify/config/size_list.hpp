#pragma once

#include <string_view>
#include <vector>

#include "ramify/tree/grammar.hpp"

namespace ramify {

/// The sizes of an option: "1000", a list "100,1000,1e4", or a geometric grid "from:to:count"
/// (geometric_grid). In the order given, spaces ignored.
///
/// Throws Error for anything else, for an empty list and for a size given twice.
/// @param what  names the option in the message: "--n"
std::vector<Size> read_sizes(std::string_view what, std::string_view text);

/// The sizes of a law, in the same words, to 1e300: real numbers, whole ones below 2^53. Throws Error.
std::vector<double> read_law_sizes(std::string_view what, std::string_view text);

}  // namespace ramify
