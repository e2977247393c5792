#pragma once

#include "ramify/optimise/minimum.hpp"

namespace ramify {

/// An end of an interval.
struct ProfileEnd {
  Point place;   ///< the end, and the other parameters that are best there
  bool is_open;  ///< the box ends here, and the function has not risen so far: nothing bounds the parameter
};

struct ProfileInterval {
  ProfileEnd low, high;
};

/// Half the 95 % point of chi-square with one degree of freedom: what a negative log-likelihood rises by at
/// the ends of its 95 % interval (Wilks 1938).
inline constexpr double rise_of_95 = 1.9207294103470627;

/// All values of one parameter around a minimum at which the function, minimised over the other parameters,
/// is at most `rise` above the minimum: the profile interval. Cost: some 6 minimisations an end, each from
/// the minimum before.
/// @param further  other values of the other parameters (all but this one) from which they are minimised too
/// at the
///                 ends found, where their own path may have missed a lower minimum
ProfileInterval profile_interval(const Objective& objective, const Minimum& minimum, std::size_t parameter,
                                 double rise = rise_of_95, std::span<const Point> further = {});

}  // namespace ramify
