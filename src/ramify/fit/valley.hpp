#pragma once

#include <string>
#include <vector>

#include "ramify/fit/family_fit.hpp"

namespace ramify {

/// Minus a log-likelihood above its minimum at the ends of the 95 % region of two parameters: half of
/// chi-square's 95 % point with two degrees of freedom.
inline constexpr double rise_of_two = 2.995732273553991;

/// A stop on the valley.
struct ValleyStop {
  Point searched;  ///< (log a, log b)
  ValleyPoint::Place place;
};

/// The valley of a likelihood of two shapes a <= b: for every a+b the best pair, from end to end of the 95 %
/// region, 25 stops at equal steps of log(a+b) and the estimate among them.
///
/// Counts of streams fix R(a,b), and a valley follows R(a,b) = constant: from even splits of a wide fraction
/// to lopsided ones of a narrow fraction. Cost: some 2,000 evaluations.
/// @param minus_log_likelihood  of log a and log b, the same for (a,b) and (b,a)
/// @param best                  its minimum
std::vector<ValleyStop> valley(const Objective& minus_log_likelihood, const Point& best);

/// How much better R(a,b) is known than the shapes, in a clause; empty where that is not known.
std::string valley_note(const FamilyFit& fit);

}  // namespace ramify
