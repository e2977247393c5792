#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/io/table.hpp"
#include "ramify/report/picture_file.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify::cli {

/// A comma-separated list, spaces trimmed; commas inside parentheses belong to the item: "beta(1,5),bst" is
/// two.
std::vector<std::string> split_list(const std::string& text);

/// Threads for --threads: the number given (1 to 1024), else as many as the machine has cores.
unsigned read_threads(const std::string& text);

/// Writes a text to standard output, or atomically to the file of -o. Throws Error where that fails.
void emit(const std::string& text, const std::string& output_file);
/// The same of a table, as CSV.
void emit(const Table& table, const std::string& output_file);

/// The file of --plot; nothing where the option was not given. Throws Error for a name that is no picture's.
std::optional<PictureFile> picture_file(const std::string& text);

/// Refuses more than 10^13 nodes unless --yes was given.
void require_consent(double nodes, bool yes);

/// A progress line on standard error; does nothing where that is not a terminal.
std::function<void(double done, double total)> progress_line(const std::string& label);

/// Ends the progress line.
void clear_progress_line();

}  // namespace ramify::cli
