#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ramify/text/source_text.hpp"

namespace ramify {

/// The forms in which a file holds trees (docs/formats.md).
enum class TreeFormat { newick, nexus, swc, mtg, qsm, edges, flowlines, parens, json };

/// "newick".
std::string_view name_of(TreeFormat format);

/// Of all formats.
std::vector<std::string> tree_format_names();

/// Nothing for "auto". Throws Error, naming the nearest, for an unknown name.
std::optional<TreeFormat> parse_tree_format(std::string_view name);

/// Finds the format by what the text begins with. Throws Error with its place where it is none of them, or
/// no text at all. O(length) at worst.
TreeFormat detect_tree_format(const SourceText& source);

}  // namespace ramify
