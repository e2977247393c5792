#include "ramify/random/stream.hpp"

namespace ramify {

void Stream::refill() noexcept {
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto words = r123::Philox4x64{}(counter_, key_);
    for (std::size_t i = 0; i < block_words; ++i) words_[block * block_words + i] = words[i];
    ++counter_[0];
  }
  next_ = 0;
}

}  // namespace ramify
