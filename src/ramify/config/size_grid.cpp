#include "ramify/config/size_grid.hpp"

#include <algorithm>
#include <cmath>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <fmt/format.h>

#include "ramify/core/error.hpp"

namespace ramify {
namespace {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

Size rounded(const Digits50& value) {
  return static_cast<Size>(boost::multiprecision::floor(value + 0.5));
}

void require_common(Size from, std::size_t count) {
  if (from < 1 || from > max_size)
    throw Error(fmt::format("a grid from {}", from), "sizes in a grid go from 1 to 2^62", "write from = 100");
  if (count < 1 || count > max_grid_sizes)
    throw Error(fmt::format("a grid with count = {}", count),
                fmt::format("a grid has 1 to {} sizes", max_grid_sizes), "write count = 9");
}

}  // namespace

std::vector<Size> geometric_grid(Size from, Size to, std::size_t count) {
  require_common(from, count);
  if (to > max_size) throw Error(fmt::format("a grid to {}", to), "sizes go up to 2^62", "take a smaller to");
  if (to < from)
    throw Error(fmt::format("a grid from {} to {}", from, to), "a grid goes upwards", "exchange from and to");
  if ((from == to) != (count == 1))
    throw Error(fmt::format("a grid from {} to {} with count = {}", from, to, count),
                "both ends belong to the grid, so only from = to has count = 1", "change count or to");
  std::vector<Size> sizes{from};
  const Digits50 ratio = Digits50(to) / from;
  for (std::size_t j = 1; j < count; ++j) {
    const Digits50 exponent = Digits50(j) / (count - 1);
    sizes.push_back(j + 1 == count ? to : rounded(from * boost::multiprecision::pow(ratio, exponent)));
  }
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

std::vector<Size> scaled_grid(Size from, double factor, std::size_t count) {
  require_common(from, count);
  if (!(factor > 1) || !std::isfinite(factor))
    throw Error(fmt::format("a grid with factor = {}", factor), "a grid goes upwards: its factor is above 1",
                "write factor = 4 or factor = \"1/0.23\"");
  std::vector<Size> sizes;
  Digits50 size = from;
  for (std::size_t j = 0; j < count; ++j, size *= factor) {
    if (size > max_size)
      throw Error(fmt::format("a grid from {} by {} with count = {}", from, factor, count),
                  fmt::format("size {} passes 2^62", j + 1), fmt::format("take count = {} at most", j));
    sizes.push_back(rounded(size));
  }
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

}  // namespace ramify
