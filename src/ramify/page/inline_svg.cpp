#include "ramify/page/inline_svg.hpp"

#include <algorithm>
#include <array>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

/// The tag without its attributes xmlns and xmlns:...
std::string without_namespaces(std::string tag) {
  for (std::size_t at = tag.find(" xmlns"); at != std::string::npos; at = tag.find(" xmlns", at)) {
    const std::size_t open = tag.find('"', at), close = tag.find('"', open + 1);
    tag.erase(at, close + 1 - at);
  }
  return tag;
}

/// The tag with the prefix in every id and every reference to one.
std::string with_prefix(std::string_view tag, std::string_view prefix) {
  constexpr std::array<std::string_view, 5> marks{" id=\"", " id='", "href=\"#", "href='#", "url(#"};
  std::string text;
  for (std::size_t at = 0; at < tag.size();) {
    const auto* const mark =
        std::ranges::find_if(marks, [&](auto m) { return tag.substr(at).starts_with(m); });
    if (mark == marks.end()) {
      text += tag[at++];
      continue;
    }
    text.append(*mark).append(prefix);
    at += mark->size();
  }
  return text;
}

bool opens(std::string_view rest, std::string_view element) {
  return rest.starts_with(std::string("<").append(element).append(">"));
}

}  // namespace

std::string inline_svg(std::string_view svg, std::string_view prefix) {
  const std::size_t begin = svg.find("<svg");
  RAMIFY_EXPECTS(begin != std::string_view::npos);
  std::string text;
  text.reserve(svg.size());
  for (std::size_t at = begin; at < svg.size();) {
    const std::string_view rest = svg.substr(at);
    if (rest.front() != '<') {  // text goes through as it is
      const std::string_view content = rest.substr(0, rest.find('<'));
      text += content;
      at += content.size();
      continue;
    }
    std::string_view tag = rest.substr(0, std::min(rest.find('>'), rest.size() - 1) + 1);
    for (const std::string_view element : {"title", "desc"})
      if (opens(rest, element)) {
        const std::string close = std::string("</").append(element).append(">");
        at += std::min(rest.find(close), rest.size() - close.size()) + close.size();
        tag = {};
      }
    if (tag.empty()) continue;
    text += at == begin ? without_namespaces(with_prefix(tag, prefix)) : with_prefix(tag, prefix);
    at += tag.size();
  }
  return text;
}

}  // namespace ramify
