#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ramify {

/// A table as aligned plain text, for a terminal or a README:
///
///     claim  estimate  verdict     method
///     -----  --------  ----------  -------------------------
///     C6        2.001  reproduced  slope over 9 sizes, which
///                                  goes on in the next line
///
/// Columns whose fields are all numbers (or empty) are set to the right; the last column is wrapped at
/// spaces.
///
/// @param rows   each as long as the header; a field has no line breaks
/// @param width  longest line, 0 for no limit; the last column keeps at least 24 characters, whatever width
/// says
std::string text_table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows, std::size_t width = 0);

/// Columns of the terminal that standard output is; 0 where it is none (a pipe, a file).
std::size_t terminal_width();

}  // namespace ramify
