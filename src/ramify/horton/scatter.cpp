#include "ramify/horton/scatter.hpp"

#include <cmath>
#include <limits>

#include <boost/math/distributions/students_t.hpp>

namespace ramify {
namespace {

constexpr std::size_t fewest_values = 5;
constexpr double outlier_level = 0.05;

/// The least-squares line through the known values' logarithms.
struct Line {
  std::vector<std::size_t> places;
  std::vector<double> residuals;
  double mean = 0, spread = 0;  ///< of the places; sum of their squared distances from it
  double squares = 0;           ///< of the residuals

  explicit Line(std::span<const double> values) {
    double log_mean = 0, product = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!(values[k] > 0)) continue;
      places.push_back(k);
      mean += static_cast<double>(k);
      log_mean += std::log(values[k]);
    }
    mean /= static_cast<double>(places.size());
    log_mean /= static_cast<double>(places.size());
    for (const std::size_t k : places) {
      const double x = distance(k);
      spread += x * x;
      product += x * std::log(values[k]);
    }
    for (const std::size_t k : places) {
      residuals.push_back(std::log(values[k]) - log_mean - product / spread * distance(k));
      squares += residuals.back() * residuals.back();
    }
  }

  double distance(std::size_t place) const { return static_cast<double>(place) - mean; }
  double known() const { return static_cast<double>(places.size()); }
};

}  // namespace

double scatter_error(RatioKind kind, std::span<const double> rising) {
  const Line line(rising);
  if (line.places.size() < 3) return std::numeric_limits<double>::quiet_NaN();
  double slopes = 0;
  for (const double slope : log_slopes(kind, rising)) slopes += slope * slope;
  return std::sqrt(slopes * line.squares / (line.known() - 2));
}

std::vector<std::size_t> off_the_line(std::span<const double> values) {
  const Line line(values);
  std::vector<std::size_t> found;
  if (line.places.size() < fewest_values) return found;
  const double degrees = line.known() - 3;
  const double limit = quantile(boost::math::students_t(degrees),
                                1 - outlier_level / 2 / static_cast<double>(line.places.size()));
  for (std::size_t i = 0; i < line.places.size(); ++i) {
    const double x = line.distance(line.places[i]);
    const double freedom = 1 - 1 / line.known() - x * x / line.spread;  // 1 - leverage
    const double square = line.residuals[i] * line.residuals[i];
    const double others = (line.squares - square / freedom) / degrees;
    // An exact line but for one value leaves others = 0, in rounding errors below it.
    if (square > limit * limit * std::max(others, 0.0) * freedom + 1e-24) found.push_back(line.places[i]);
  }
  return found;
}

}  // namespace ramify
