#include "ramify/config/size_list.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "ramify/config/size_grid.hpp"
#include "ramify/core/error.hpp"
#include "ramify/core/number.hpp"
#include "ramify/statistic/exact_law.hpp"
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

std::string compact(std::string_view text) {
  std::string compact(text);
  std::erase_if(compact, [](unsigned char c) { return std::isspace(c) != 0; });
  return compact;
}

std::vector<std::string> grid_parts(std::string_view what, const std::string& text) {
  auto parts = split(text, ':');
  if (parts.size() != 3)
    throw Error(fmt::format("{} '{}'", what, text), "a grid is from:to:count", "write it like 100:1e4:5");
  return parts;
}

/// What two readings of a list have in common.
template <class N, class Read>
std::vector<N> read_list(std::string_view what, const std::string& text, Read read) {
  std::vector<N> sizes;
  for (const auto& part : split(text, ',')) {
    const N n = read(part);
    if (std::find(sizes.begin(), sizes.end(), n) != sizes.end())
      throw Error(fmt::format("{} {} given twice", what, n), "each size has its rows once", "name it once");
    sizes.push_back(n);
  }
  return sizes;
}

constexpr double whole_below = 9007199254740992;  // 2^53

/// "1e18" and what read_count reads.
double read_law_size(std::string_view what, std::string_view text) {
  const auto real = parse_real(text);
  if (!real || *real < whole_below) return static_cast<double>(read_count(what, text));
  if (*real > largest_law_size)
    throw Error(fmt::format("{} {}", what, text), "laws reach to 1e300", "take a smaller n");
  return *real;
}

/// Both ends and what lies between them in equal ratios.
std::vector<double> law_grid(double from, double to, std::size_t count) {
  if (from < 1 || to <= from || count < 2 || count > max_grid_sizes)
    throw Error(fmt::format("a grid from {} to {} with count = {}", from, to, count),
                fmt::format("a grid goes from 1 or more upwards, in 2 to {} sizes", max_grid_sizes),
                "write it like 1e6:1e18:13");
  std::vector<double> sizes;
  for (std::size_t j = 0; j < count; ++j) {
    const double share = static_cast<double>(j) / static_cast<double>(count - 1);
    const double size = j == 0 ? from : j + 1 == count ? to : from * std::pow(to / from, share);
    sizes.push_back(size < whole_below ? std::round(size) : size);
  }
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

}  // namespace

std::vector<Size> read_sizes(std::string_view what, std::string_view text) {
  const std::string list = compact(text);
  const auto read = [what](const std::string& part) { return read_count(what, part); };
  if (list.find(':') == std::string::npos) return read_list<Size>(what, list, read);
  const auto parts = grid_parts(what, list);
  return geometric_grid(read(parts[0]), read(parts[1]), read(parts[2]));
}

std::vector<double> read_law_sizes(std::string_view what, std::string_view text) {
  const std::string list = compact(text);
  const auto read = [what](const std::string& part) { return read_law_size(what, part); };
  if (list.find(':') == std::string::npos) return read_list<double>(what, list, read);
  const auto parts = grid_parts(what, list);
  if (read(parts[1]) > static_cast<double>(max_size))
    return law_grid(read(parts[0]), read(parts[1]), read_count(what, parts[2]));
  const auto sizes = read_sizes(what, text);
  return {sizes.begin(), sizes.end()};
}

}  // namespace ramify
