#pragma once

/// Preconditions between parts of the program: checked in debug builds and in CI (RAMIFY_CONTRACTS), free in
/// release builds. A broken contract is a bug in ramify, never bad input, so it ends the program.
#if defined(RAMIFY_CONTRACTS)
namespace ramify::detail {
[[noreturn]] void contract_broken(const char* condition, const char* file, int line);
}
#define RAMIFY_EXPECTS(condition) \
  ((condition) ? static_cast<void>(0) : ::ramify::detail::contract_broken(#condition, __FILE__, __LINE__))
#else
#define RAMIFY_EXPECTS(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
