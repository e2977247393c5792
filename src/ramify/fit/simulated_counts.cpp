#include "ramify/fit/simulated_counts.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include <fmt/format.h>

#include "ramify/core/error.hpp"
#include "ramify/random/hash.hpp"
#include "ramify/random/stream.hpp"
#include "ramify/statistic/horton_strahler.hpp"
#include "ramify/tree/measure.hpp"

namespace ramify {
namespace {

constexpr std::uint64_t simulation_seed = 1996;
constexpr Size most_simulated = 1'000'000;

/// Sums over trees of the streams of every order and of their products.
class CountSums {
 public:
  explicit CountSums(std::size_t orders)
      : orders_(orders), sums_(orders), products_(orders * orders), tops_(orders) {}

  void add(const HortonStrahler::Counts& streams, std::size_t top) {
    ++trees_;
    ++tops_[top];
    for (std::size_t j = 0; j < orders_; ++j) {
      const auto count = static_cast<double>(streams[j]);
      sums_[j] += count;
      for (std::size_t k = 0; k <= j; ++k)
        products_[j * orders_ + k] += count * static_cast<double>(streams[k]);
    }
  }

  StreamCounts moments() const {
    StreamCounts found;
    for (const double sum : sums_) found.means.push_back(sum / trees_);
    found.covariances.resize(orders_ * orders_);
    for (std::size_t j = 0; j < orders_; ++j)
      for (std::size_t k = 0; k <= j; ++k)
        found.covariances[j * orders_ + k] = found.covariances[k * orders_ + j] =
            (products_[j * orders_ + k] - sums_[j] * found.means[k]) / (trees_ - 1);
    found.order_tail.assign(orders_ + 1, 0.0);
    const double all = trees_ + static_cast<double>(orders_) / 2;
    for (std::size_t s = orders_; s-- > 0;)
      found.order_tail[s] = found.order_tail[s + 1] + (tops_[s] + 0.5) / all;
    return found;
  }

 private:
  std::size_t orders_;
  double trees_ = 0;
  std::vector<double> sums_, products_, tops_;
};

}  // namespace

Size size_with_tips_of(const Family& family, Size n) {
  return family.model->is_binary ? n : n / 2;
}

std::uint64_t simulated_trees(Size n) {
  constexpr Size most_nodes = 50'000'000, fewest = 200, most = 2000;
  return std::clamp<Size>(most_nodes / (n + n / 2 + 1), fewest, most);
}

std::string cannot_simulate(Size n) {
  if (n < most_simulated) return {};
  return fmt::format("it is simulated, which takes minutes for trees of more than {} tips", most_simulated);
}

StreamCounts simulated_stream_counts(const Family& family, std::span<const double> values, Size n,
                                     const Cancellation& cancellation) {
  const Model model = family.at(values);
  const Size size = size_with_tips_of(family, n);
  const StreamKey key{simulation_seed, hash_text(fmt::format("{} #{}", family.name, n))};
  CountSums sums(static_cast<std::size_t>(std::bit_width(n + 1)));
  for (std::uint64_t replicate = 0; replicate < simulated_trees(n); ++replicate) {
    if (cancellation.requested()) throw Interrupted();
    Stream stream(key, replicate);
    HortonStrahler fold;
    const std::size_t top = measure(model.grown().grow(size, stream, cancellation), fold);
    sums.add(fold.streams(), top);
  }
  return sums.moments();
}

}  // namespace ramify
