#pragma once

#include <string>
#include <string_view>

#include "ramify/tree/tree.hpp"

namespace ramify {

/// The tree as text: an external node is E, an internal node its children in parentheses: (EE), ((EE)E).
/// O(nodes).
std::string to_parentheses(const Tree& tree);

/// The tree that the text stands for; white space is skipped.
///
/// Any arity >= 1 is read: (E), (EEE). Throws Error with the column where the text stops making sense:
/// another character, a parenthesis left open or closed twice, an internal node without children, no tree, or
/// more than one. O(length), no recursion.
/// @param where  a name for messages ("word", a file name)
Tree from_parentheses(std::string_view text, std::string_view where = "tree");

}  // namespace ramify
