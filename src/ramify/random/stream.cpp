#include "ramify/random/stream.hpp"

#include <Random123/philox.h>

namespace ramify {

void Stream::refill() noexcept {
  using Philox = r123::Philox4x64;
  const Philox::key_type key{{key_[0], key_[1]}};
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto words = Philox{}(Philox::ctr_type{{counter_[0], counter_[1], counter_[2], counter_[3]}}, key);
    for (std::size_t i = 0; i < block_words; ++i) words_[block * block_words + i] = words[i];
    ++counter_[0];
  }
  next_ = 0;
}

}  // namespace ramify
