#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ramify {

/// The known names closest to a mistyped one (edit distance without regard to case, a swap of neighbours
/// counting once): at most three, closest first; none where nothing is near.
std::vector<std::string> nearest_names(std::string_view name, const std::vector<std::string>& known);

/// "did you mean bst or beta? " or "" where nothing is near; for the remedy of an Error.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& known);

/// Throws Error: there is no `kind` ("model") of that name; what is near, and the list to see.
[[noreturn]] void refuse_name(std::string_view kind, std::string_view name,
                              const std::vector<std::string>& known);

}  // namespace ramify
