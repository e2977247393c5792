#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace ramify {

/// A branch that is recorded in pieces: its length is the sum of theirs, its radius their mean weighted by
/// length, plain where no length is known or above 0. A value that is NaN is left out; NaN where all are.
class BranchPieces {
 public:
  void add(double length, double radius) {
    if (!std::isnan(length)) {
      has_length_ = true;
      length_ += length;
    }
    if (std::isnan(radius)) return;
    radii_ += radius;
    ++radius_count_;
    if (!(length > 0)) return;
    weighted_ += length * radius;
    weight_ += length;
  }

  double length() const { return has_length_ ? length_ : none; }

  double radius() const {
    if (radius_count_ == 0) return none;
    return weight_ > 0 ? weighted_ / weight_ : radii_ / radius_count_;
  }

 private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  bool has_length_ = false;
  std::uint32_t radius_count_ = 0;
  double length_ = 0, weighted_ = 0, weight_ = 0, radii_ = 0;
};

}  // namespace ramify
