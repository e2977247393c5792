#include "ramify/model/galton_watson.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "ramify/model/model_info.hpp"
#include "ramify/random/alias_table.hpp"
#include "ramify/random/uniform.hpp"
#include "ramify/tree/largest_order.hpp"

namespace ramify {
namespace {

/// Weight of one node with two children more, n2 -> n2 + 1, over that of n2: n1 (n1-1) ratio / ((n2+1)
/// (n2+2)).
double step(Size n, Size forks, double ratio) {
  const auto forked = static_cast<double>(forks), single = static_cast<double>(n - 2 * forks - 1);
  return single * (single - 1) * ratio / ((forked + 1) * (forked + 2));
}

/// The start of the only rotation of the children's numbers that is a tree: after the first lowest partial
/// sum of number-1.
std::size_t tree_start(const std::vector<std::uint32_t>& arity) {
  std::int64_t sum = 0, lowest = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < arity.size(); ++i) {
    sum += static_cast<std::int64_t>(arity[i]) - 1;
    if (sum >= lowest) continue;
    lowest = sum;
    start = i + 1;
  }
  return start % arity.size();
}

}  // namespace

GaltonWatson::GaltonWatson(double p0, double p1, double p2) : p1_(p1), ratio_(p0 * p2 / (p1 * p1)) {
  require_distribution(fmt::format("galton_watson({},{},{})", p0, p1, p2), std::array{p0, p1, p2});
  require_domain(info(), std::array{p0, p1, p2});
}

std::size_t GaltonWatson::largest_order(Size n) const {
  return largest_strahler_order((n + 1) / 2);
}

/// Outwards from the mode, as far as weights are above 1e-18 of it.
Size GaltonWatson::draw_forks(Size n, Stream& stream) const {
  const Size most = (n - 1) / 2;
  if (p1_ == 0) return most;
  Size low = 0, high = most;
  while (low < high) {  // the ratio falls: the mode is where it passes 1
    const Size middle = low + (high - low) / 2;
    if (step(n, middle, ratio_) > 1)
      low = middle + 1;
    else
      high = middle;
  }
  constexpr double negligible = 1e-18;
  Size first = low;
  std::vector<double> below, weights{1};
  for (double weight = 1; first > 0; --first) {
    weight /= step(n, first - 1, ratio_);
    if (weight < negligible) break;
    below.push_back(weight);
  }
  for (Size forks = low; forks < most && weights.back() >= negligible; ++forks)
    weights.push_back(weights.back() * step(n, forks, ratio_));
  weights.insert(weights.begin(), below.rbegin(), below.rend());
  std::vector<AliasCell> cells(weights.size());
  build_alias_cells(weights, cells);
  return first + draw_alias(std::span<const AliasCell>(cells), stream);
}

void GaltonWatson::require_size(Size n) const {
  if (n == 0 || (p1_ == 0 && n % 2 == 0))
    throw Error(fmt::format("n = {} for galton_watson", n),
                n == 0 ? "a tree has one node at least" : "without one-child nodes their number is odd",
                "take another n");
}

Tree GaltonWatson::grow(Size n, Stream& stream, const Cancellation&, std::vector<std::uint64_t>*) const {
  const Size forks = draw_forks(n, stream);
  std::vector<std::uint32_t> arity(n - forks, 1);
  std::fill(arity.begin(), arity.begin() + static_cast<std::ptrdiff_t>(forks + 1), 0);
  arity.insert(arity.end(), forks, 2);
  for (std::size_t i = arity.size() - 1; i > 0; --i) std::swap(arity[i], arity[uniform_below(stream, i + 1)]);
  std::rotate(arity.begin(), arity.begin() + static_cast<std::ptrdiff_t>(tree_start(arity)), arity.end());
  return Tree(std::move(arity));
}

const ModelInfo& GaltonWatson::info() {
  static const ModelInfo info{
      .name = "galton_watson",
      .parameters = {positive("p0"), {"p1", {.low = 0, .holds_low = true}}, positive("p2")},
      .together = ", sum 1; n odd where p1 = 0",
      .n_counts = "nodes, external ones counted",
      .description = "Galton-Watson tree of 0, 1 or 2 children given its number of nodes",
      .source = "A20; Dvoretzky and Motzkin 1947",
      .make = [](std::span<const double> v) -> AnyModel {
        return std::make_shared<const GaltonWatson>(v[0], v[1], v[2]);
      },
      .is_split = false};
  return info;
}

}  // namespace ramify
