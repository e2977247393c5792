#pragma once

#include <span>
#include <vector>

#include "ramify/fit/response.hpp"

namespace ramify {

/// Points of a response surface in ascending p, each p once.
class RatioCurve {
 public:
  std::span<const ResponsePoint> points() const { return points_; }

  /// Adds points; one that is already there is replaced by the one with more trees.
  void merge(std::span<const ResponsePoint> points);

  /// The point at exactly p, or none.
  const ResponsePoint* find(double p) const;

 private:
  std::vector<ResponsePoint> points_;
};

}  // namespace ramify
