#pragma once

#include <cstdint>
#include <string_view>

namespace ramify {

/// What a verdict is made from.
enum class EvidenceKind : std::uint8_t {
  exact,      ///< laws at finite n, enumeration
  limit,      ///< exact laws to n = 10^300, extrapolated with a bound
  sampled,    ///< trees: intervals of 99 % over all sampled intervals of the ledger together
  fitted,     ///< a model's parameters
  measured,   ///< trees of nature
  published,  ///< numbers of a source
};

/// How far that carries.
enum class Standing : std::uint8_t {
  proved,        ///< up to the error bounds of the computation there is nothing left to believe
  extrapolated,  ///< numbers of a few digits, and that they go on as they did
  seen,          ///< in so many trees
};

std::string_view to_string(EvidenceKind kind);
std::string_view to_string(Standing standing);

}  // namespace ramify
