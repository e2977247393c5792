#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "program.hpp"

#include "ramify/core/cancellation.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/workforce.hpp"
#include "ramify/io/table.hpp"
#include "ramify/report/picture_file.hpp"
#include "ramify/tree/grammar.hpp"

namespace ramify::cli {

/// A comma-separated list, spaces trimmed; commas inside parentheses belong to the item: "beta(1,5),bst" is
/// two.
std::vector<std::string> split_list(const std::string& text);

/// Declares --threads, in the one way it is said of a verb with one result.
void add_threads(Verb& verb, std::string& threads);

/// Threads for --threads: the number given (1 to 1024), else as many as the machine has cores.
unsigned read_threads(const std::string& text);

/// Those threads, and the others of a team: without --threads its processes divide the machine's cores.
Workforce read_workforce(const std::string& threads, Team* team);

/// A real number of an option, "0.23" or "1/4.35"; throws Error for anything else.
double read_real(const std::string& option, const std::string& text);

/// Trees of a model that a statistic is compared with, for --replicates: 99 or more.
std::uint64_t read_replicates(const std::string& text);

/// Trees that a fit is tried on again, for --bootstrap: none, or 40 or more.
std::uint64_t read_bootstrap(const std::string& text);

/// From now on standard output is no terminal, whatever it looks like: mpirun gives rank 0 a pseudo-terminal
/// even where its own output goes into a file.
void forget_terminal();

/// Whoever read standard output has gone: no fault, and nothing to say.
class ClosedPipe {};

/// Where a verb writes, and in which form a table: what -o/--output and --csv say.
struct Output {
  std::string file;  ///< empty, or "-": standard output
  bool csv = false;

  /// Declares -o/--output, in the one way it is said everywhere.
  void add_to(Verb& verb);
  /// The same, and --csv: of a verb that writes tables.
  void add_table_to(Verb& verb);

  /// The table is for a person to read: on a terminal, and --csv is not asked for.
  bool is_for_reading() const;
};

/// Writes a text to standard output, or atomically to the file of -o. Throws Error where that fails,
/// ClosedPipe where nobody reads any more.
void emit(const std::string& text, const Output& output = {});
/// The same of a table: as CSV, or aligned where it is for reading (io/readable.hpp).
void emit(const Table& table, const Output& output);

/// The file of --plot; nothing where the option was not given. Throws Error for a name that is no picture's.
std::optional<PictureFile> picture_file(const std::string& text);

/// Refuses more than 10^13 nodes unless --yes was given.
void require_consent(double nodes, bool yes);

/// Says that a job of several processes has nothing for all but one of them to do.
void say_alone(const std::string& what, const Team& team);

/// From now on work that takes longer than two seconds says so on standard error where that is a terminal:
/// "law: 12 s", or how much is done where the work tells it.
void show_progress(const std::string& label);

/// What work calls now and then to tell how much is done; any thread.
std::function<void(double done, double total)> progress_line(const std::string& label);

/// Ends the progress line, before anything else is written.
void clear_progress_line();

}  // namespace ramify::cli
