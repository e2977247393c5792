#include "ramify/config/size_list.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "ramify/config/size_grid.hpp"
#include "ramify/core/error.hpp"
#include "ramify/text/read_count.hpp"

namespace ramify {
namespace {

std::vector<std::string> split(const std::string& text, char mark) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == mark)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

std::vector<Size> read_grid(std::string_view what, const std::string& text) {
  const auto parts = split(text, ':');
  if (parts.size() != 3)
    throw Error(fmt::format("{} '{}'", what, text), "a grid is from:to:count", "write it like 100:1e4:5");
  return geometric_grid(read_count(what, parts[0]), read_count(what, parts[1]), read_count(what, parts[2]));
}

}  // namespace

std::vector<Size> read_sizes(std::string_view what, std::string_view text) {
  std::string compact(text);
  std::erase_if(compact, [](unsigned char c) { return std::isspace(c) != 0; });
  if (compact.find(':') != std::string::npos) return read_grid(what, compact);
  std::vector<Size> sizes;
  for (const auto& part : split(compact, ',')) {
    const Size n = read_count(what, part);
    if (std::find(sizes.begin(), sizes.end(), n) != sizes.end())
      throw Error(fmt::format("{} {} given twice", what, n), "each size has its rows once", "name it once");
    sizes.push_back(n);
  }
  return sizes;
}

}  // namespace ramify
