#pragma once

#include <array>
#include <cstdint>
#include <limits>

namespace ramify {

/// What a replicate's random numbers depend on: nothing else does, so a tree can be replayed alone.
struct StreamKey {
  std::uint64_t seed = 0;  ///< the user's seed
  std::uint64_t cell = 0;  ///< hash of (model, n)
};

/// Independent streams within one replicate.
enum class Lane : std::uint64_t {
  growth = 0,         ///< the tree
  walk = 1,           ///< choices a fold makes on the finished tree (the walk to the last node)
  external_walk = 2,  ///< the walk to an external node
  form = 3,           ///< the form that rules of shape give a grown tree
  limb_walk = 4,      ///< how its branches wander from end to end
};

/// A counter-based stream of 64-bit words: Philox4x64-10 (Salmon et al. 2011) of the counter
/// (block, replicate, lane, 0) under the key (seed, cell).
///
/// A UniformRandomBitGenerator. Any two of the 2^64 replicates, lanes and cells are independent streams of
/// 2^66 words, at no cost of set-up. 3 ns a word (bench/random_bench.cpp holds it against PCG and xoshiro).
class Stream {
 public:
  using result_type = std::uint64_t;

  Stream(StreamKey key, std::uint64_t replicate, Lane lane = Lane::growth) noexcept
      : key_{key.seed, key.cell}, counter_{0, replicate, static_cast<std::uint64_t>(lane), 0} {}

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  result_type operator()() noexcept {
    if (next_ == words_.size()) refill();
    return words_[next_++];
  }

 private:
  // Four blocks at a time: they do not depend on each other, so the processor works on them together.
  static constexpr std::size_t blocks = 4;
  static constexpr std::size_t block_words = 4;

  void refill() noexcept;  // out of line: the growing loop keeps the registers

  // As words: the generator's own header is the source's alone.
  std::array<std::uint64_t, 2> key_;
  std::array<std::uint64_t, 4> counter_;
  std::array<std::uint64_t, blocks * block_words> words_{};
  std::size_t next_ = blocks * block_words;
};

}  // namespace ramify
