#pragma once

#include <string>
#include <string_view>

#include "ramify/page/page.hpp"

namespace ramify {

/// The page as one HTML document that needs nothing else: no network, no script, pictures inline; light or
/// dark as the reader's system is. Landmarks (header, nav, main, footer), headings in order from one h1, a
/// caption and scopes for every table, an alternative text for every picture; what is wide scrolls by itself,
/// also by keyboard; filters are radio buttons and rules of the style sheet. The same bytes for the same
/// page.
std::string write_html(const Page& page);

/// A text as HTML shows it, within an element or an attribute in double quotes. Control characters become
/// U+FFFD.
std::string html_text(std::string_view text);

}  // namespace ramify
