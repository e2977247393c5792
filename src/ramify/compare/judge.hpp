#pragma once

#include "ramify/compare/finding.hpp"
#include "ramify/compare/verdict.hpp"

namespace ramify {

/// The one rule. Of a number that the statement gives: `reproduced` where the interval contains the theory
/// and excludes every rival, `refuted` where it excludes the theory. Of a bound: `reproduced` where the whole
/// interval keeps it (and excludes the rivals), `refuted` where the whole interval breaks it. Else
/// `inconclusive`. There is no tolerance.
Decision judge(const Statement& statement, const Interval& interval);

/// The statement with a rival in the place of its theory, and the theory among the rivals: what must never be
/// reproduced where the statement is.
Statement with_rival(const Statement& statement, std::size_t rival);

}  // namespace ramify
