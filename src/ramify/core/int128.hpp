#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace ramify {

/// Exact sums of integer statistics: 64-bit values, their squares and products, over any number of trees.
///
/// Costs a second to include: for sources and the few headers that hold such sums.
using int128 = boost::multiprecision::int128_t;

}  // namespace ramify
