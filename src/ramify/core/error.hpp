#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace ramify {

/// Bad input, in one line: "problem (why): what to do".
///
/// The one exception type of ramify; it is caught in main and nowhere else. Broken preconditions inside the
/// program are contracts (contract.hpp), expected outcomes are values.
class Error : public std::runtime_error {
 public:
  /// @param problem  what is wrong, naming the offending value
  /// @param why      the rule it breaks
  /// @param remedy   what the user can do
  Error(std::string_view problem, std::string_view why, std::string_view remedy);
};

/// A place in an input file; line and column start at 1, 0 means unknown.
struct SourceLocation {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
};

/// "file:line:column: ", without the parts that are unknown.
std::string to_prefix(const SourceLocation& location);

/// The work was stopped by the user (Ctrl-C); what was complete has been kept.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace ramify
