#pragma once

#include <string>

#include "ramify/page/page.hpp"

namespace ramify {

/// The page as Markdown (CommonMark, tables as GitHub has them). Of a picture the caption and the alternative
/// text: a text holds no pictures. The same bytes for the same page.
std::string write_markdown(const Page& page);

}  // namespace ramify
