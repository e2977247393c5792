#include "ramify/optimise/profile.hpp"

#include <cmath>

#include <boost/math/tools/toms748_solve.hpp>

namespace ramify {
namespace {

/// The function, minimised over all parameters but one, less what it may be.
class Profile {
 public:
  Profile(const Objective& objective, const Minimum& minimum, std::size_t parameter, double rise)
      : objective_(objective),
        parameter_(parameter),
        allowed_(minimum.value + rise),
        others_(minimum.at),
        best_(minimum.at[parameter]) {
    others_.erase(others_.begin() + static_cast<std::ptrdiff_t>(parameter));
    const double second = minimum.second(parameter, parameter);
    step_ = second > 0 ? 2 / std::sqrt(second) : 0.1;
  }

  double operator()(double value) const {
    return std::min(objective_.value(best_at(value)) - allowed_, large);
  }

  /// @param side  -1 down, 1 up
  ProfileEnd end(int side) const {
    const double last = side < 0 ? objective_.low[parameter_] : objective_.high[parameter_];
    double inside = best_, step = step_;
    while (true) {
      const double next = side < 0 ? std::max(last, inside - step) : std::min(last, inside + step);
      if ((*this)(next) > 0) return {best_at(root(inside, next)), false};
      if (next == last) return {best_at(last), true};
      inside = next;
      step *= 1.6;
    }
  }

 private:
  static constexpr double large = 1e30;  // where there is no value

  /// The point with that value at which the function is smallest.
  Point best_at(double value) const {
    Point at = others_;
    if (!at.empty()) at = minimise(held(objective_, parameter_, value), others_).at;
    at.insert(at.begin() + static_cast<std::ptrdiff_t>(parameter_), value);
    return at;
  }

  double root(double inside, double outside) const {
    std::uintmax_t steps = 100;
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-10 * std::max(1.0, std::abs(a)); };
    const auto [low, high] = boost::math::tools::toms748_solve(*this, std::min(inside, outside),
                                                               std::max(inside, outside), near, steps);
    return (low + high) / 2;
  }

  const Objective& objective_;
  std::size_t parameter_;
  double allowed_;
  Point others_;
  double best_, step_;
};

}  // namespace

ProfileInterval profile_interval(const Objective& objective, const Minimum& minimum, std::size_t parameter,
                                 double rise) {
  const Profile profile(objective, minimum, parameter, rise);
  return {profile.end(-1), profile.end(1)};
}

}  // namespace ramify
