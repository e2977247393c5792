#include "ramify/core/error.hpp"

#include <fmt/format.h>

namespace ramify {

Error::Error(std::string_view problem, std::string_view why, std::string_view remedy)
    : std::runtime_error(fmt::format("{} ({}): {}", problem, why, remedy)) {}

std::string to_prefix(const SourceLocation& location) {
  if (location.file.empty()) return {};
  if (location.line == 0) return location.file + ": ";
  if (location.column == 0) return fmt::format("{}:{}: ", location.file, location.line);
  return fmt::format("{}:{}:{}: ", location.file, location.line, location.column);
}

}  // namespace ramify
