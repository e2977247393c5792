#include "ramify/family/all_families.hpp"
#include "ramify/model/ford.hpp"

namespace ramify {

Family ford_family() {
  return {.name = "ford",
          .model = &Ford::info(),
          .fixed = {},
          .parameters = {{"alpha", {SearchScale::Kind::plain}, 0, 0.99, {0.05, 0.3, 0.6, 0.9}}},
          .mirror = Mirror::none,
          .alike = ""};
}

}  // namespace ramify
