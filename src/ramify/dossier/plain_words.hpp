#pragma once

#include <string>
#include <vector>

#include "ramify/dossier/findings.hpp"

namespace ramify {

/// What was found, in sentences made from the numbers: how the tree branches; which family is best, which are
/// as good, which are out; how well the best fits, and in what the tree departs from it; what these data
/// cannot tell.
std::vector<std::string> plain_words(const Subject& subject, const Findings& findings);

/// AIC above the best's: up to the first families are as good, above the second they are out.
inline constexpr double as_good = 2, is_out = 10;

/// "a, b and c".
std::string listed(const std::vector<std::string>& items);

}  // namespace ramify
