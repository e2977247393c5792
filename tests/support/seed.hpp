#pragma once

#include <cstdint>
#include <string_view>

#include "ramify/random/hash.hpp"

namespace ramify::test {

/// The fixed seed of a test: a hash of its tag, so that no two tests share random numbers by accident and a
/// failure can be replayed.
constexpr std::uint64_t seed_of(std::string_view tag) {
  return hash_text(tag, hash_text("ramify tests"));
}

}  // namespace ramify::test
