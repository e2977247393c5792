#pragma once

#include <string>
#include <string_view>

namespace ramify {

/// An SVG document as an element of an HTML page: without its prolog and namespaces, which HTML knows,
/// without its titles, which browsers show as tooltips, and with a prefix before every id, so that pictures
/// of one page do not take each other's parts. O(length).
/// @param svg  a document, with an element `svg`
std::string inline_svg(std::string_view svg, std::string_view prefix);

}  // namespace ramify
