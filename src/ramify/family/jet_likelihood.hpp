#pragma once

#include <array>
#include <cmath>
#include <utility>

#include <ceres/jet.h>

#include "ramify/family/family.hpp"

namespace ramify {

/// A likelihood from its formula, which any scalar can go through: Ceres's Jets carry the gradient.
/// @param family   whose scales the searched numbers are on
/// @param formula  formula(std::array<T, parameters>): minus the log-likelihood at these parameters
template <std::size_t parameters, class Formula>
SplitLikelihood jet_likelihood(const Family& family, Formula formula) {
  std::array<SearchScale, parameters> scales;
  for (std::size_t i = 0; i < parameters; ++i) scales[i] = family.parameters[i].scale;
  return [scales, formula = std::move(formula)](std::span<const double> at, double& value, double* gradient) {
    if (gradient == nullptr) {
      std::array<double, parameters> numbers;
      for (std::size_t i = 0; i < parameters; ++i) numbers[i] = scales[i].back(at[i]);
      value = formula(numbers);
      return std::isfinite(value);
    }
    using Jet = ceres::Jet<double, static_cast<int>(parameters)>;
    std::array<Jet, parameters> numbers;
    for (std::size_t i = 0; i < parameters; ++i) {
      numbers[i] = Jet(scales[i].back(at[i]), static_cast<int>(i));
      numbers[i].v *= scales[i].slope(at[i]);
    }
    const Jet found = formula(numbers);
    value = found.a;
    for (std::size_t i = 0; i < parameters; ++i) gradient[i] = found.v[static_cast<int>(i)];
    return std::isfinite(value) && found.v.allFinite();
  };
}

}  // namespace ramify
