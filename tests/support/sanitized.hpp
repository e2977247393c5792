#pragma once

#include <cstdint>

namespace ramify::test {

/// Whether the tests are built under a sanitizer (presets asan-ubsan and tsan): it watches memory, arithmetic
/// and threads, at every tree alike, and takes ten to forty times as long. Whether a sampler has its law is
/// for the release build to say.
#ifdef RAMIFY_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// How many trees or draws a statistical test takes: all, or a twentieth under a sanitizer. There `agrees`
/// decides as ever, and `rejected` (goodness.hpp), which needs them all, does not.
constexpr std::uint64_t replicates(std::uint64_t all) {
  return sanitized ? all / 20 : all;
}

}  // namespace ramify::test
