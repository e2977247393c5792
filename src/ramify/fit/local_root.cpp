#include "ramify/fit/local_root.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "ramify/core/contract.hpp"
#include "ramify/optimise/least_squares.hpp"

namespace ramify {

LocalRoot solve_local_root(std::span<const CurveSample> samples, double target, double p, double slope) {
  RAMIFY_EXPECTS(samples.size() >= 4);
  double scale = 0;
  for (const CurveSample& sample : samples) scale = std::max(scale, std::abs(sample.p - p));
  // The parameters are of order one: t* = (p* - p) / scale, and the slope and curvature in t.
  const auto evaluate = [&](std::span<const double> at, std::span<double> residuals, double* jacobian) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double distance = (samples[i].p - p) / scale - at[0], error = samples[i].standard_error;
      residuals[i] = (at[1] * distance + at[2] * distance * distance - (samples[i].mean - target)) / error;
      if (jacobian == nullptr) continue;
      jacobian[3 * i] = -(at[1] + 2 * at[2] * distance) / error;
      jacobian[3 * i + 1] = distance / error;
      jacobian[3 * i + 2] = distance * distance / error;
    }
    return true;
  };
  const LeastSquares fit = least_squares({evaluate, samples.size()}, {0, slope * scale, 0});
  const bool converged = fit.converged && !fit.covariance.empty();
  const double degrees = static_cast<double>(samples.size()) - 3;
  const double misfit = boost::math::gamma_q(degrees / 2, fit.sum_of_squares / 2);
  return {p + scale * fit.at[0], converged ? scale * std::sqrt(fit.variance(0)) : 0, fit.at[1] / scale,
          misfit, converged};
}

}  // namespace ramify
