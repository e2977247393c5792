#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ramify/compare/verdict.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// "equals", "at most", "at least"
std::string_view to_string(Relation relation);

/// "1/log 2, the ratio of nodes (1.442695041); ..."
std::string in_words(const std::vector<NamedValue>& values);

/// "[0.8983, 0.8985]", with as many decimals as tell the ends apart.
std::string interval_text(const Basis& basis);

/// "at most 0.9102", with as many decimals as the interval.
std::string theory_text(const Finding& finding);

/// "ok: 11 means, 2.2 s.e."
std::string sampler_text(const SamplerCheck& check);

/// verdicts.csv of a reproduction.
Table verdict_table(const std::vector<Verdict>& verdicts);

/// The same for a terminal: claim, statement, theory, the interval, what it rests on, how the samplers stand
/// beside their laws, verdict.
std::string verdict_text(const std::vector<Verdict>& verdicts);

/// The number of the claim that a part, or a plot, is of: "C20" of "C20.2" and of "C20_bst_order".
std::string_view claim_of(std::string_view name);

/// Verdicts that differ from those in a committed verdicts.csv, "C20.2: refuted, was inconclusive", and those
/// that only one of the two has. A verdict is known by its number and its statement. Throws Error where the
/// file cannot be read.
/// @param claims  to which a run was narrowed, by number: committed verdicts of others it cannot have; empty:
///                it has all
std::vector<std::string> changed_verdicts(const std::vector<Verdict>& verdicts,
                                          const std::filesystem::path& reference,
                                          const std::vector<std::string_view>& claims);

}  // namespace ramify
