#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace ramify::bench {

// The two generators most often recommended, for comparison only: neither can jump to a replicate's stream at
// no cost.

/// PCG XSL RR 128/64 (O'Neill 2014).
class Pcg64 {
 public:
  using result_type = std::uint64_t;

  constexpr Pcg64(std::uint64_t seed, std::uint64_t stream) : increment_(Wide{stream} << 1 | 1) {
    state_ = (increment_ + seed) * multiplier + increment_;
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  constexpr result_type operator()() {
    state_ = state_ * multiplier + increment_;
    const auto folded = static_cast<std::uint64_t>(state_ >> 64) ^ static_cast<std::uint64_t>(state_);
    return std::rotr(folded, static_cast<int>(state_ >> 122));
  }

 private:
  __extension__ using Wide = unsigned __int128;
  static constexpr Wide multiplier = Wide{0x2360ed051fc65da4} << 64 | 0x4385df649fccf645;

  Wide increment_;
  Wide state_;
};

/// xoshiro256** (Blackman and Vigna 2018).
class Xoshiro256 {
 public:
  using result_type = std::uint64_t;

  constexpr explicit Xoshiro256(const std::array<std::uint64_t, 4>& state) : state_(state) {}

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  constexpr result_type operator()() {
    const std::uint64_t word = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return word;
  }

 private:
  std::array<std::uint64_t, 4> state_;
};

// The first words their authors print.
static_assert(Pcg64(42, 54)() == 0x86b1da1d72062b68);
static_assert(Xoshiro256({1, 2, 3, 4})() == 11520);

}  // namespace ramify::bench
