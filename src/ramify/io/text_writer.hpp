#pragma once

#include <cstddef>
#include <string>

#include "ramify/io/table.hpp"

namespace ramify {

/// The table as aligned plain text, for a terminal or a README:
///
///     claim  estimate  verdict     method
///     -----  --------  ----------  -------------------------
///     C6        2.001  reproduced  slope over 9 sizes, which
///                                  goes on in the next line
///
/// Columns of numbers are set to the right; the last column is wrapped at spaces. A field has no line breaks.
///
/// @param width  longest line, 0 for no limit; the last column keeps at least 24 characters, whatever width
/// says
std::string write_text(const Table& table, std::size_t width = 0);

}  // namespace ramify
