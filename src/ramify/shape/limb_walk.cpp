#include "ramify/shape/limb_walk.hpp"

#include <array>
#include <cmath>

#include <boost/random/normal_distribution.hpp>

#include "ramify/core/contract.hpp"

namespace ramify {
namespace {

double length(const Limb& limb) {
  return std::hypot(limb.end[0] - limb.start[0], limb.end[1] - limb.start[1], limb.end[2] - limb.start[2]);
}

/// A free walk: where each of its steps ends.
void walk_freely(std::span<Point3> places, double deviation, Stream& chance) {
  boost::random::normal_distribution<double> normal(0, deviation);
  Point3 place{};
  for (Point3& next : places) {
    for (double& coordinate : place) coordinate += normal(chance);
    next = place;
  }
}

}  // namespace

std::vector<Point3> bends_of_walks(std::span<const Limb> limbs, const LimbWalk& walk, Stream& chance) {
  RAMIFY_EXPECTS(walk.steps >= 2);
  const auto steps = static_cast<double>(walk.steps);
  std::vector<Point3> bends, places(walk.steps);
  bends.reserve(limbs.size() * (walk.steps - 1));
  for (const Limb& limb : limbs) {
    walk_freely(places, walk.deviation * length(limb) / std::sqrt(steps), chance);
    for (std::size_t step = 1; step < walk.steps; ++step) {
      const double part = static_cast<double>(step) / steps;
      Point3 bend{};
      for (std::size_t i = 0; i < bend.size(); ++i)
        bend[i] = limb.start[i] + part * (limb.end[i] - limb.start[i]) + places[step - 1][i] -
                  part * places.back()[i];
      bends.push_back(bend);
    }
  }
  return bends;
}

}  // namespace ramify
