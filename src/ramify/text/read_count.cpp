#include "ramify/text/read_count.hpp"

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"

namespace ramify {

std::uint64_t read_count(std::string_view what, std::string_view text) {
  constexpr std::uint64_t largest = std::uint64_t{1} << 62;
  const auto value = parse_count(text);
  if (!value || *value > largest)
    throw Error(fmt::format("{} '{}'", what, text), "not a whole number from 0 to 2^62",
                "write it like 1000, 1e6 or 2^20");
  return *value;
}

}  // namespace ramify
