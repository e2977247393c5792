#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ramify/random/stream.hpp"
#include "ramify/shape/shape.hpp"

namespace ramify {

/// Limbs that go as random walks instead of straight (lightning, E26).
struct LimbWalk {
  std::size_t steps;  ///< of every limb
  double deviation;   ///< of a free walk's end in each coordinate, as part of the limb's length
};

/// The places between the steps, of every limb in turn: those of a random walk that ends where the limb does.
///
/// With W_j the sum of j independent normal vectors of standard deviation `deviation` L/sqrt(steps) in each
/// coordinate, the j-th place is start + (j/steps) (end - start) + W_j - (j/steps) W_steps. Two steps at
/// least. O(limbs steps).
std::vector<Point3> bends_of_walks(std::span<const Limb> limbs, const LimbWalk& walk, Stream& chance);

}  // namespace ramify
