#include "one_way_trees.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "ramify/core/contract.hpp"
#include "ramify/core/error.hpp"
#include "ramify/law/split_rows.hpp"
#include "ramify/statistic/strahler.hpp"

namespace ramify {
namespace {

/// The sizes of the children of a tree of size n.
std::array<Size, 2> only_children(SplitRows& rows, Size n) {
  const SplitRow row = rows.row(n);
  RAMIFY_EXPECTS(row.weights.size() == 1);
  return {row.smaller(0), row.larger(0)};
}

/// Subtrees of one size: how many there are, and what each is.
struct Subtrees {
  std::uint64_t times = 0;
  std::uint8_t order = 0;
  bool begins = true;  ///< a stream; an external node does
};
using BySize = std::map<Size, Subtrees, std::greater<>>;

/// From the root down: children have entries behind that of their parent.
BySize sizes_below(SplitRows& rows, Size n) {
  BySize sizes;
  sizes[n].times = 1;
  for (const auto& [size, subtrees] : sizes) {
    if (size == 0) break;
    for (const Size child : only_children(rows, size)) sizes[child].times += subtrees.times;
  }
  return sizes;
}

}  // namespace

std::vector<std::uint8_t> one_way_orders(const Model& model, Size largest_n,
                                         const Cancellation& cancellation) {
  SplitRows rows(model);
  std::vector<std::uint8_t> orders{0};
  for (Size n = 1; n <= largest_n; ++n) {
    if (cancellation.requested()) throw Interrupted();
    const auto [smaller, larger] = only_children(rows, n);
    orders.push_back(
        static_cast<std::uint8_t>(join_orders(std::array{orders[smaller], orders[larger]}).order));
  }
  return orders;
}

OneWayCounts one_way_counts(const Model& model, Size n) {
  SplitRows rows(model);
  BySize sizes = sizes_below(rows, n);
  OneWayCounts counts;
  for (auto place = sizes.rbegin(); place != sizes.rend(); ++place) {
    auto& [size, tree] = *place;
    if (size > 0) {
      const auto [smaller, larger] = only_children(rows, size);
      const auto joined = join_orders(std::array{sizes.at(smaller).order, sizes.at(larger).order});
      tree.order = static_cast<std::uint8_t>(joined.order);
      tree.begins = joined.begins;
    }
    const std::size_t orders = std::max(counts.nodes.size(), std::size_t{tree.order} + 1);
    counts.nodes.resize(orders);
    counts.streams.resize(orders);
    counts.nodes[tree.order] += tree.times;
    if (tree.begins) counts.streams[tree.order] += tree.times;
  }
  return counts;
}

}  // namespace ramify
