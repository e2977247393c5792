#include "ramify/horton/order_range.hpp"

namespace ramify {

std::string_view suffix_of(OrderRange range) {
  switch (range) {
    case OrderRange::all:
      return "";
    case OrderRange::below_top:
      return "_below_top";
    case OrderRange::inner:
      return "_inner";
    case OrderRange::dense:
      break;
  }
  return "_dense";
}

std::optional<OrderSpan> orders_of(OrderRange range, std::span<const double> counts) {
  const std::size_t first = range == OrderRange::inner ? 1 : 0;
  std::size_t end = counts.size();  // behind the last
  if (range == OrderRange::dense) {
    end = 0;
    while (end < counts.size() && counts[end] >= OrderSpan::many) ++end;
  } else if (range != OrderRange::all && end > 0) {
    --end;
  }
  if (end < first + 2) return std::nullopt;
  return OrderSpan{first, end - 1};
}

}  // namespace ramify
