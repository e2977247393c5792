#include "ramify/fit/ratio_curve.hpp"

#include <algorithm>

namespace ramify {

void RatioCurve::merge(std::span<const ResponsePoint> points) {
  for (const ResponsePoint& point : points) {
    const auto place = std::lower_bound(points_.begin(), points_.end(), point.p,
                                        [](const ResponsePoint& known, double p) { return known.p < p; });
    if (place == points_.end() || place->p != point.p) {
      points_.insert(place, point);
    } else if (place->trees < point.trees) {
      *place = point;
    }
  }
}

const ResponsePoint* RatioCurve::find(double p) const {
  const auto place =
      std::find_if(points_.begin(), points_.end(), [p](const ResponsePoint& point) { return point.p == p; });
  return place == points_.end() ? nullptr : &*place;
}

}  // namespace ramify
