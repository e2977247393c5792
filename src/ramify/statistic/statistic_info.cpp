#include "ramify/statistic/statistic_info.hpp"

#include <cctype>

#include <fmt/format.h>

namespace ramify {

std::string StatisticInfo::columns() const {
  switch (shape) {
    case Columns::one:
      return std::string(name);
    case Columns::orders:
      return fmt::format("{0}_0..{0}_K", name);
    case Columns::upper_orders:
    case Columns::differences:
      return fmt::format("{0}_1..{0}_K", name);
    case Columns::pairs:
      return fmt::format("{0}_1_0..{0}_K_K", name);
    case Columns::lower_pairs:
      return fmt::format("{0}_1_0..{0}_K_(K-1)", name);
  }
  return {};
}

std::string StatisticInfo::title() const {
  constexpr std::size_t longest = 60;
  std::string_view words = description;
  if (words.size() > longest) words = words.substr(0, words.find(':'));
  std::string title = fmt::format("{} ({})", words, name);
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  return title;
}

std::vector<OrderPlace> StatisticInfo::places(std::size_t largest_order) const {
  if (shape == Columns::one) return {{0, 0}};
  std::vector<OrderPlace> places;
  for (std::size_t high = shape == Columns::orders ? 0 : 1; high <= largest_order; ++high) {
    const std::size_t last = !by_pairs() ? 0 : shape == Columns::pairs ? high : high - 1;
    for (std::size_t low = 0; low <= last; ++low) places.push_back({high, low});
  }
  return places;
}

std::string StatisticColumn::name(std::size_t leaf_order) const {
  const StatisticInfo& info = *statistic;
  if (info.shape == Columns::one) return std::string(info.name);
  if (info.shape == Columns::differences) return fmt::format("{}_{}", info.name, place.high);
  if (!info.by_pairs()) return fmt::format("{}_{}", info.name, place.high + leaf_order);
  return fmt::format("{}_{}_{}", info.name, place.high + leaf_order, place.low + leaf_order);
}

}  // namespace ramify
