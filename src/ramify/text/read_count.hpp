#pragma once

#include <cstdint>
#include <string_view>

namespace ramify {

/// "1000", "1e6", "2^20", "1_000_000"; throws Error for anything but a whole number from 0 to 2^62.
///
/// @param what  names the option in the message: "--n"
std::uint64_t read_count(std::string_view what, std::string_view text);

}  // namespace ramify
