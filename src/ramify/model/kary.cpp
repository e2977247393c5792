#include "ramify/model/kary.hpp"

#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {

Kary::Kary(double k) : k_(static_cast<std::size_t>(k >= 2 && k <= 1000 ? k : 0)) {
  if (k_ >= 2 && static_cast<double>(k_) == k) return;
  throw Error(fmt::format("kary(k) with k = {}", k), "k must be a whole number from 2 to 1000",
              "write kary(3)");
}

}  // namespace ramify
