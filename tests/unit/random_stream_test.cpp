#include <array>
#include <random>
#include <set>
#include <vector>

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include "ramify/random/hash.hpp"
#include "ramify/random/stream.hpp"

namespace ramify {
namespace {

using Counter = std::array<std::uint64_t, 4>;

Counter philox(const Counter& counter, StreamKey key) {
  const r123::Philox4x64::ctr_type c{{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x64::key_type k{{key.seed, key.cell}};
  const auto words = r123::Philox4x64{}(c, k);
  return {words[0], words[1], words[2], words[3]};
}

// Random123 1.09, tests/kat_vectors, lines "philox4x64 10".
TEST(Philox, GivesTheKnownAnswers) {
  constexpr std::uint64_t ones = UINT64_MAX;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (Counter{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Counter{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
  EXPECT_EQ(philox({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
                   {0x452821e638d01377, 0xbe5466cf34e90c6c}),
            (Counter{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}));
}

TEST(Stream, StartsWithTheKnownAnswer) {
  Stream stream({0, 0}, 0);
  EXPECT_EQ(stream(), 0x16554d9eca36314cu);
  EXPECT_EQ(stream(), 0xdb20fe9d672d0fdcu);
  EXPECT_EQ(stream(), 0xd7e772cee186176bu);
  EXPECT_EQ(stream(), 0x7e68b68aec7ba23bu);
}

// The words are Philox of (block, replicate, lane, 0): streams that differ in any of the three, or in a half
// of the key, never share a block.
TEST(Stream, IsPhiloxOfItsCounter) {
  const StreamKey key{1996, 0xfeedu};
  for (const auto lane : {Lane::growth, Lane::walk}) {
    Stream stream(key, 77, lane);
    for (std::uint64_t block = 0; block < 11; ++block)
      for (const std::uint64_t word : philox({block, 77, static_cast<std::uint64_t>(lane), 0}, key))
        ASSERT_EQ(stream(), word) << "block " << block;
  }
}

TEST(Stream, SharesNoWordsAcrossReplicatesLanesCellsAndSeeds) {
  std::set<std::uint64_t> words;
  std::size_t drawn = 0;
  for (const std::uint64_t seed : {0u, 1u, 1996u})
    for (const std::uint64_t cell : {0u, 1u, 2u})
      for (const std::uint64_t replicate : {0u, 1u, 2u, 1000000u})
        for (const auto lane : {Lane::growth, Lane::walk}) {
          Stream stream({seed, cell}, replicate, lane);
          for (int i = 0; i < 100; ++i, ++drawn) words.insert(stream());
        }
  EXPECT_EQ(words.size(), drawn);
}

TEST(Stream, IsAUniformRandomBitGenerator) {
  static_assert(std::uniform_random_bit_generator<Stream>);
  EXPECT_EQ(Stream::min(), 0u);
  EXPECT_EQ(Stream::max(), UINT64_MAX);
}

// FNV-1a of the text, finished by SplitMix64's mixer; computed by a second program from the published
// definitions.
TEST(HashText, NeverChanges) {
  EXPECT_EQ(hash_text(""), 0xf52a15e9a9b5e89bu);
  EXPECT_EQ(hash_text("a"), 0x2c0bdbf481420f8u);
  EXPECT_EQ(hash_text("bst()#1000"), 0x5e4a1dac56d9cb15u);
}

}  // namespace
}  // namespace ramify
