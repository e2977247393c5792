#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ramify/compare/verdict.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// verdicts.csv of a reproduction.
Table verdict_table(const std::vector<Verdict>& verdicts);

/// The same for a terminal: claim, statement, theory, estimate with its interval, largest n, verdict.
std::string verdict_text(const std::vector<Verdict>& verdicts);

/// verdict.json of one run folder.
std::string verdict_json(const std::vector<Verdict>& verdicts);

/// Which verdicts are held against committed ones: those of a run that was narrowed to some claims cannot
/// have the others.
enum class Compared { all, those_in_both };

/// Verdicts that differ from those in a committed verdicts.csv, "C20.2: refuted, was inconclusive", and those
/// that only one of the two has. A verdict is known by its number and its statement. Throws Error where the
/// file cannot be read.
std::vector<std::string> changed_verdicts(const std::vector<Verdict>& verdicts,
                                          const std::filesystem::path& reference, Compared compared);

}  // namespace ramify
