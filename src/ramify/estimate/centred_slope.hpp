#pragma once

namespace ramify {

/// The slope of the least-squares line through points (x, y) with weights w, whose weighted mean of x is
/// known: sum w (x - mean) y / sum w (x - mean)^2. Two different x at least.
class CentredSlope {
 public:
  explicit CentredSlope(double mean_x) : mean_x_(mean_x) {}

  void add(double x, double y, double weight = 1) {
    const double centred = x - mean_x_;
    variance_ += weight * centred * centred;
    covariance_ += weight * centred * y;
  }

  double value() const { return covariance_ / variance_; }
  /// sum w (x - mean)^2; where w = 1/error^2 of y, the slope has the standard error 1/sqrt of it.
  double weight() const { return variance_; }

 private:
  double mean_x_;
  double variance_ = 0, covariance_ = 0;
};

}  // namespace ramify
