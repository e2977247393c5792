#pragma once

#include <cstddef>
#include <string_view>

namespace ramify {

/// Throws Error where an internal node of a tree has other than two children.
/// @param where  names the tree in messages
void require_binary(std::size_t children, std::string_view where);

}  // namespace ramify
