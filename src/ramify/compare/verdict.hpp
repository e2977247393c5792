#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "ramify/compare/finding.hpp"

namespace ramify {

/// What the evidence says of a statement. Undecided is an answer, not a failure.
enum class Decision : std::uint8_t { reproduced, refuted, inconclusive };

std::string_view to_string(Decision decision);

/// Sampled means held against exact ones at the same n: whether the sampler does what the law says, which is
/// another question than whether the claim is true.
struct SamplerCheck {
  std::size_t means = 0;
  double worst_z = 0;       ///< the largest |z|
  double allowed_z = 0;     ///< of all means of the ledger together one in a million ledgers goes beyond
  bool takes_trees = true;  ///< false where the statement is of no sampled trees

  bool failed() const { return means > 0 && worst_z > allowed_z; }
  /// "ok", "failed", "not sampled", or "-" where there is nothing to sample.
  std::string_view word() const;
};

/// One row of the verdict table.
struct Verdict {
  Finding finding;
  Decision decision;
  SamplerCheck sampler;
};

}  // namespace ramify
