#include "ramify/ranks/hand_out.hpp"

#include <numeric>
#include <utility>

#include "ramify/core/contract.hpp"

namespace ramify {

HandOut::HandOut(std::size_t items, std::vector<unsigned> threads)
    : items_(items),
      threads_(std::move(threads)),
      in_hand_(threads_.size()),
      all_threads_(std::accumulate(threads_.begin(), threads_.end(), std::size_t{0})) {}

std::vector<std::size_t> HandOut::next(std::size_t member) {
  std::vector<std::size_t> places;
  const auto limit = [&] {
    const bool plenty = items_ - given_ > 2 * all_threads_;
    return std::size_t{threads_[member]} * (plenty ? 2 : 1);
  };
  while (given_ < items_ && in_hand_[member] < limit()) {
    places.push_back(given_++);
    ++in_hand_[member];
  }
  return places;
}

void HandOut::done(std::size_t member) {
  RAMIFY_EXPECTS(in_hand_[member] > 0);
  --in_hand_[member];
  ++done_;
}

}  // namespace ramify
