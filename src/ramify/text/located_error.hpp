#pragma once

#include <string>
#include <string_view>

#include "ramify/core/error.hpp"

namespace ramify {

/// A text without line ends and other marks of control, which are written `\x0a`: a message is one line,
/// whatever the file holds.
std::string one_line(std::string_view text);

/// "file:line:column: problem (why): what to do".
Error error_at(const SourceLocation& place, std::string_view problem, std::string_view why,
               std::string_view remedy);

/// The same error with its place in front: for errors of parts that know nothing of files (Model::parse).
Error located(const Error& error, const SourceLocation& place);

}  // namespace ramify
