#include <array>
#include <cmath>
#include <vector>

#include "ramify/family/all_families.hpp"
#include "ramify/family/beta_cell.hpp"
#include "ramify/family/beta_shapes.hpp"
#include "ramify/family/split_sizes.hpp"
#include "ramify/model/beta.hpp"

namespace ramify {
namespace {

/// P(left = i) = I_((i+1)/n)(a,b) - I_(i/n)(a,b), integrals of the density x^(a-1) (1-x)^(b-1) / B(a,b),
/// whose derivatives are integrals as well.
///
/// Beside its middle the density over a cell is a product of a power that depends on i, x, and one that
/// depends on j: they are computed once for each size, so a split costs no power. Cells at the ends and steep
/// ones are integrated one by one (beta_cell.hpp).
class BetaLikelihood {
 public:
  explicit BetaLikelihood(const ObservedSplits& observed) : sizes_(observed) {
    for (const ObservedSplit& split : observed.splits()) {
      splits_.push_back(split);
    }
    for (const Size size : sizes_.sizes) {
      const double whole = static_cast<double>(size), middle = whole + 0.5;
      log_size_.push_back(std::log(std::max(whole, 1.0)));
      log_middle_.push_back(std::log(middle));
      for (std::size_t q = 0; q < points; ++q)
        beside_.push_back(std::log1p((CellPoints::get().at[q] - 0.5) / middle));
    }
  }

  LogCell operator()(double a, double b) const {
    const LogBeta straight(a, b), mirrored = straight.exchanged();
    const std::vector<double> powers_a = powers(a - 1), powers_b = powers(b - 1);
    LogCell sum{0, 0, 0};
    for (std::size_t s = 0; s < splits_.size(); ++s) {
      LogCell cell = log_probability(s, straight, powers_a, powers_b);
      if (!splits_[s].is_even())
        cell = either(cell, log_probability(s, mirrored, powers_b, powers_a).exchanged());
      sum.log += splits_[s].count * cell.log;
      sum.by_a += splits_[s].count * cell.by_a;
      sum.by_b += splits_[s].count * cell.by_b;
    }
    return sum;
  }

 private:
  static constexpr std::size_t points = CellPoints::count;

  /// ((i + t) / (i + 1/2))^exponent at the eight points, size after size.
  std::vector<double> powers(double exponent) const {
    std::vector<double> found(beside_.size());
    for (std::size_t k = 0; k < found.size(); ++k) found[k] = std::exp(exponent * beside_[k]);
    return found;
  }

  /// That the smaller child is the left one.
  LogCell log_probability(std::size_t s, const LogBeta& beta, const std::vector<double>& left_powers,
                          const std::vector<double>& right_powers) const {
    const double i = static_cast<double>(splits_[s].smaller), j = static_cast<double>(splits_[s].larger);
    if (i < least_smaller || change_over_cell(beta.a, beta.b, i, j) > most_change)
      return log_cell(beta, i, j);
    const auto [smaller, larger, node] = sizes_.places[s];
    const double* left = &left_powers[smaller * points];
    const double* right = &right_powers[larger * points];
    const double* beside_left = &beside_[smaller * points];
    const double* beside_right = &beside_[larger * points];
    const auto& weight = CellPoints::get().weight;
    double sum = 0, by_a = 0, by_b = 0;
    for (std::size_t q = 0; q < points; ++q) {
      const double part = weight[q] * left[q] * right[points - 1 - q];
      sum += part;
      by_a += part * beside_left[q];
      by_b += part * beside_right[points - 1 - q];
    }
    const double x = log_middle_[smaller] - log_size_[node], rest = log_middle_[larger] - log_size_[node];
    return {(beta.a - 1) * x + (beta.b - 1) * rest + std::log(sum) - log_size_[node] - beta.value,
            x + by_a / sum - beta.by_a, rest + by_b / sum - beta.by_b};
  }

  /// The log of the sum of two probabilities.
  static LogCell either(const LogCell& one, const LogCell& other) {
    if (one.log < other.log) return either(other, one);
    const double ratio = std::exp(other.log - one.log), share = ratio / (1 + ratio);
    return {one.log + std::log1p(ratio), one.by_a + share * (other.by_a - one.by_a),
            one.by_b + share * (other.by_b - one.by_b)};
  }

  SplitSizes sizes_;
  std::vector<ObservedSplit> splits_;
  std::vector<double> log_size_, log_middle_;  ///< of every size i: log i, log(i + 1/2)
  std::vector<double> beside_;                 ///< log((i + t) / (i + 1/2)) at the eight points
};

SplitLikelihood beta_likelihood(const ObservedSplits& observed) {
  const std::vector<FamilyParameter> shapes = beta_shapes();
  return [likelihood = BetaLikelihood(observed), scale_a = shapes[0].scale, scale_b = shapes[1].scale](
             std::span<const double> at, double& value, double* gradient) {
    const LogCell found = likelihood(scale_a.back(at[0]), scale_b.back(at[1]));
    value = -found.log;
    if (gradient != nullptr) {
      gradient[0] = -found.by_a * scale_a.slope(at[0]);
      gradient[1] = -found.by_b * scale_b.slope(at[1]);
    }
    return std::isfinite(found.log) && std::isfinite(found.by_a) && std::isfinite(found.by_b);
  };
}

}  // namespace

Family beta_family() {
  return {.name = "beta",
          .model = &Beta::info(),
          .fixed = {},
          .parameters = beta_shapes(),
          .mirror = Mirror::exchanged,
          .alike = shapes_exchanged,
          .of_splits = beta_likelihood};
}

}  // namespace ramify
