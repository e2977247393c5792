#include "ramify/statistic/stream_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ramify/estimate/centred_slope.hpp"
#include "ramify/statistic/strahler.hpp"
#include "ramify/tree/branch_pieces.hpp"

namespace ramify {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A stream as far as it was met.
struct OpenStream {
  std::uint8_t order = 0;
  BranchPieces pieces;
};

/// Sums over the streams of every order.
class OrderSums {
 public:
  void add(const OpenStream& stream) {
    if (sums_.size() <= stream.order) sums_.resize(stream.order + std::size_t{1});
    Sums& sums = sums_[stream.order];
    if (const double length = stream.pieces.length(); !std::isnan(length)) {
      sums.length += length;
      ++sums.lengths;
    }
    if (const double radius = stream.pieces.radius(); !std::isnan(radius)) {
      sums.radius += radius;
      ++sums.radii;
    }
  }

  std::vector<double> mean_lengths() const {
    std::vector<double> means;
    for (const Sums& sums : sums_) means.push_back(sums.lengths > 0 ? sums.length / sums.lengths : none);
    return means;
  }
  std::vector<double> mean_radii() const {
    std::vector<double> means;
    for (const Sums& sums : sums_) means.push_back(sums.radii > 0 ? sums.radius / sums.radii : none);
    return means;
  }

 private:
  struct Sums {
    double length = 0, lengths = 0, radius = 0, radii = 0;
  };
  std::vector<Sums> sums_;
};

/// The stream that goes on above a fork: that of its highest child, unless two are as high. The others end.
OpenStream join(std::span<const OpenStream> below, OrderSums& sums) {
  const auto highest = std::ranges::max_element(below, {}, &OpenStream::order);
  const auto as_high = std::ranges::count(below, highest->order, &OpenStream::order);
  OpenStream above;
  if (as_high == 1) {
    above = *highest;
  } else {
    above.order = static_cast<std::uint8_t>(highest->order + 1);
  }
  for (auto child = below.begin(); child != below.end(); ++child)
    if (as_high > 1 || child != highest) sums.add(*child);
  return above;
}

}  // namespace

StreamGeometry stream_geometry(const Tree& tree, std::span<const double> lengths,
                               std::span<const double> radii) {
  RAMIFY_EXPECTS(tree.node_count() > 0);
  OrderSums sums;
  std::vector<OpenStream> streams;  // of the subtrees that were met, as in measure.hpp
  for (std::size_t node = tree.node_count(); node-- > 0;) {
    const std::size_t children = tree.arity(node);
    OpenStream stream;
    if (children > 0) {
      const std::size_t first = streams.size() - children;
      stream = join(std::span(streams).subspan(first), sums);
      streams.resize(first);
    }
    stream.pieces.add(lengths.empty() ? none : lengths[node], radii.empty() ? none : radii[node]);
    streams.push_back(stream);
  }
  sums.add(streams.back());
  StreamGeometry geometry;
  if (!lengths.empty()) geometry.mean_lengths = sums.mean_lengths();
  if (!radii.empty()) geometry.mean_radii = sums.mean_radii();
  return geometry;
}

MeanRatios mean_ratios(std::span<const double> means) {
  std::vector<std::size_t> known;  // orders
  for (std::size_t k = 0; k < means.size(); ++k)
    if (means[k] > 0) known.push_back(k);
  if (known.size() < 2) return {none, none, none};
  const double orders = static_cast<double>(known.size());
  CentredSlope slope(static_cast<double>(std::accumulate(known.begin(), known.end(), std::size_t{0})) /
                     orders);
  double sum_of_ratios = 0, ratios = 0;
  for (const std::size_t k : known) {
    slope.add(static_cast<double>(k), std::log(means[k]));
    if (k + 1 == means.size() || !(means[k + 1] > 0)) continue;
    sum_of_ratios += means[k + 1] / means[k];
    ++ratios;
  }
  const std::size_t first = known.front(), last = known.back();
  return {ratios > 0 ? sum_of_ratios / ratios : none, std::exp(slope.value()),
          std::pow(means[last] / means[first], 1 / static_cast<double>(last - first))};
}

}  // namespace ramify
