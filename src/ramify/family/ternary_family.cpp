#include "ramify/family/all_families.hpp"
#include "ramify/model/ternary.hpp"

namespace ramify {

/// No law is known of it, and a node of a measured tree hardly ever has children of sizes that its split can
/// have: its counts of streams are simulated.
Family ternary_family() {
  return {.name = "ternary",
          .model = &Ternary::info(),
          .fixed = {},
          .parameters = {{"p", {SearchScale::Kind::logit, 0, 0.5}, 0.02, 1.0 / 3, {0.25, 0.08}}},
          .mirror = Mirror::none,
          .alike = ""};
}

}  // namespace ramify
