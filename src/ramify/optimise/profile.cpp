#include "ramify/optimise/profile.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ramify {
namespace {

/// The function, minimised over all parameters but one, less what it may be.
class Profile {
 public:
  Profile(const Objective& objective, const Minimum& minimum, std::size_t parameter, double rise,
          std::span<const Point> further)
      : objective_(objective),
        parameter_(parameter),
        allowed_(minimum.value + rise),
        others_(minimum.at),
        further_(further),
        best_(minimum.at[parameter]) {
    others_.erase(others_.begin() + static_cast<std::ptrdiff_t>(parameter));
    const double second = minimum.second(parameter, parameter);
    step_ = second > 0 ? 2 / std::sqrt(second) : 0.1;
  }

  /// @param side  -1 down, 1 up
  ProfileEnd end(int side) const {
    const double last = side < 0 ? objective_.low[parameter_] : objective_.high[parameter_];
    Height inside{best_, -1, 0, others_};
    double step = step_;
    std::size_t branches = further_.size();
    while (true) {
      const double next = side < 0 ? std::max(last, inside.at - step) : std::min(last, inside.at + step);
      Height reached = height(next, inside.others);
      if (reached.above > 0) {
        const ProfileEnd found = root(inside, std::move(reached));
        if (branches-- == 0) return found;
        inside = lower_elsewhere(found.place[parameter_], std::move(inside));
        if (inside.at != found.place[parameter_]) return found;
        continue;  // a lower minimum of the other parameters goes on from here
      }
      if (next == last) return {whole(last, std::move(reached.others)), true};
      inside = std::move(reached);
      step *= 1.6;
    }
  }

 private:
  static constexpr double large = 1e30;  // where there is no value

  /// Of the profile at one value of the parameter.
  struct Height {
    double at, above, slope;
    Point others;  ///< where the function is smallest
  };

  /// All parameters.
  Point whole(double at, Point others) const {
    others.insert(others.begin() + static_cast<std::ptrdiff_t>(parameter_), at);
    return others;
  }

  /// The slope of the profile is that of the function: along the others it has none.
  /// @param near  the other parameters of a value nearby
  Height height(double at, const Point& near) const {
    Point others = near;
    if (!near.empty()) others = minimise_near(held(objective_, parameter_, at), near).at;
    const Point place = whole(at, others);
    Point slopes(place.size());
    double value = 0;
    if (!objective_.contains(place) || !objective_.evaluate(place, value, slopes.data()) ||
        !std::isfinite(value))
      return {at, large, 0, near};
    return {at, value - allowed_, slopes[parameter_], std::move(others)};
  }

  /// What a minimum of the other parameters elsewhere comes to, where it is allowed; otherwise `known`.
  Height lower_elsewhere(double at, Height known) const {
    constexpr double clearly = -1e-6;
    for (const Point& start : further_)
      if (Height other = height(at, start); other.above < clearly) known = std::move(other);
    return known;
  }

  /// Newton's steps, or half the bracket where they leave it. Open where the function ends before it has
  /// risen so far.
  ProfileEnd root(Height inside, Height outside) const {
    constexpr int steps = 100;
    double next = newton(outside, inside, outside);
    Point others = inside.others;
    for (int i = 0; i < steps; ++i) {
      Height reached = height(next, inside.others);
      others = reached.others;
      Height& end = reached.above > 0 ? outside : inside;
      end = std::move(reached);
      next = newton(end, inside, outside);
      const double near = 1e-11 * std::max(1.0, std::abs(next));
      if (std::abs(next - end.at) < near || std::abs(outside.at - inside.at) < near) break;
    }
    return {whole(next, std::move(others)), outside.above == large};
  }

  static double newton(const Height& from, const Height& inside, const Height& outside) {
    const double next = from.at - from.above / from.slope;
    const auto [low, high] = std::minmax(inside.at, outside.at);
    return next >= low && next <= high ? next : (low + high) / 2;
  }

  const Objective& objective_;
  std::size_t parameter_;
  double allowed_;
  Point others_;
  std::span<const Point> further_;
  double best_, step_;
};

}  // namespace

ProfileInterval profile_interval(const Objective& objective, const Minimum& minimum, std::size_t parameter,
                                 double rise, std::span<const Point> further) {
  const Profile profile(objective, minimum, parameter, rise, further);
  return {profile.end(-1), profile.end(1)};
}

}  // namespace ramify
