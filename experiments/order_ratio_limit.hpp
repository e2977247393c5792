#pragma once

#include <functional>

#include "claim.hpp"

#include "ramify/model/model.hpp"
#include "ramify/statistic/order_count.hpp"

namespace ramify {

/// The basis of lim over k of lim over n of E X_k / E X_(k+1), X_k the nodes or streams of order k: of the
/// kind limit, extrapolated. Cost: 0.3 to 2 s.
std::function<Basis(const Evidence&)> order_ratio_limit(const Model& model, OrderCount::Of of);

/// The basis of max |x_i| where every x_i is known up to an error: of a statement that all of them are 0.
/// Takes value and error one by one.
class LargestOf {
 public:
  void add(double value, double error);

  /// The largest |x_i|, and the interval of its true value.
  double value() const { return value_; }
  Interval interval() const { return {lower_, upper_}; }

 private:
  double value_ = 0, lower_ = 0, upper_ = 0;
};

}  // namespace ramify
