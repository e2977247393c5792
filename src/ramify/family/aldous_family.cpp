#include "ramify/family/all_families.hpp"
#include "ramify/model/aldous.hpp"

namespace ramify {

Family aldous_family() {
  return {.name = "aldous",
          .model = &Aldous::info(),
          .fixed = {},
          .parameters = {{"beta", {SearchScale::Kind::log_above, -2, 0}, -1.99, 200, {-1.7, -1, 0.5, 8}}},
          .mirror = Mirror::none,
          .alike = ""};
}

}  // namespace ramify
