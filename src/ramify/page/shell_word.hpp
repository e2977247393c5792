#pragma once

#include <string>
#include <string_view>

namespace ramify {

/// A word as a POSIX shell reads it: in single quotes where it needs them.
std::string shell_word(std::string_view text);

}  // namespace ramify
