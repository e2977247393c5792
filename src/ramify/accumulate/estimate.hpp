#pragma once

namespace ramify {

/// A value with its standard error.
struct Estimate {
  double value;
  double standard_error;
};

}  // namespace ramify
