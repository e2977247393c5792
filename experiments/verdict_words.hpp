#pragma once

#include <string>
#include <vector>

#include "ramify/compare/verdict.hpp"
#include "ramify/io/table.hpp"

namespace ramify {

/// How a verdict was reached, in three sentences made of what the ledger knows: between which bounds the
/// number lies and what that rests on; what the rule makes of theory and rivals; how the sampler stands
/// beside its law.
std::string how_reached(const Verdict& verdict);

/// The negative controls of verdicts: every rival, and what is known to hold instead, in the place of the
/// theory. How far outside the interval it lies, also in widths of the interval, and what the same rule says
/// of it: what was reproduced must not be with a rival, and is with what holds instead.
Table control_table(const std::vector<Verdict>& verdicts);

}  // namespace ramify
