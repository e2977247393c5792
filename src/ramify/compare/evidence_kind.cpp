#include "ramify/compare/evidence_kind.hpp"

#include <array>
#include <cstddef>

namespace ramify {

std::string_view to_string(EvidenceKind kind) {
  static constexpr std::array<std::string_view, 6> names{"exact",  "limit",    "sampled",
                                                         "fitted", "measured", "published"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string_view to_string(Standing standing) {
  static constexpr std::array<std::string_view, 3> names{"proved", "extrapolated", "seen"};
  return names.at(static_cast<std::size_t>(standing));
}

}  // namespace ramify
