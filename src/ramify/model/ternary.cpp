#include "ramify/model/ternary.hpp"

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

Ternary::Ternary(double p) : p_(p) {
  if (p > 0 && p <= 1.0 / 3) return;
  throw Error(fmt::format("ternary(p) with p = {}", p),
              "p must lie in (0, 1/3]: above, the main child would not be the largest",
              "give a number such as 1/4.8, the white fir's");
}

}  // namespace ramify
