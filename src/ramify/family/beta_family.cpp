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

/// Powers of the shares x and 1-x over cells, beside those at their middles. The density over a cell is a
/// product of a power that depends on i and one that depends on j: computed once for each size, so that a
/// split costs no power.
class CellPowers {
 public:
  using Table = std::vector<double>;

  explicit CellPowers(const SplitSizes& sizes) {
    for (const Size size : sizes.sizes)
      for (const double t : rule_.at)
        logs_.push_back(std::log1p((t - 0.5) / (static_cast<double>(size) + 0.5)));
  }

  /// ((i + t) / (i + 1/2))^exponent, size after size.
  Table table(double exponent) const {
    Table powers(logs_.size());
    for (std::size_t k = 0; k < powers.size(); ++k) powers[k] = std::exp(exponent * logs_[k]);
    return powers;
  }

  /// log of the mean over a cell, both children by their places, and its derivatives by the exponents.
  LogCell mean(const SplitSizes::Places& split, const Table& left_powers, const Table& right_powers) const {
    constexpr std::size_t count = CellRule::points;
    const std::size_t left = split.smaller * count, right = split.larger * count + count - 1;
    double sum = 0, by_a = 0, by_b = 0;
    for (std::size_t q = 0; q < count; ++q) {
      const double part = rule_.weight[q] * left_powers[left + q] * right_powers[right - q];
      sum += part;
      by_a += part * logs_[left + q];
      by_b += part * logs_[right - q];
    }
    return {std::log(sum), by_a / sum, by_b / sum};
  }

 private:
  const CellRule& rule_ = CellRule::get();
  std::vector<double> logs_;  ///< log((i + t) / (i + 1/2)), size after size
};

/// P(left = i) = I_((i+1)/n)(a,b) - I_(i/n)(a,b), integrals of the density x^(a-1) (1-x)^(b-1) / B(a,b),
/// whose derivatives are integrals as well: cells that one panel or two are enough for by tables of powers,
/// the others one by one (beta_cell.hpp).
class BetaLikelihood {
 public:
  explicit BetaLikelihood(const ObservedSplits& observed)
      : splits_(observed.splits().begin(), observed.splits().end()), sizes_(observed), powers_(sizes_) {
    for (const Size size : sizes_.sizes) {
      const double whole = static_cast<double>(size);
      log_size_.push_back(std::log(std::max(whole, 1.0)));
      inverse_size_.push_back(1 / std::max(whole, 1.0));
      log_middle_.push_back(std::log(whole + 0.5));
    }
  }

  /// The log-likelihood with its derivatives.
  LogCell operator()(double a, double b) const {
    const CellPowers::Table powers_a = powers_.table(a - 1), powers_b = powers_.table(b - 1);
    const LogBeta beta(a, b);
    const Law straight{beta, powers_a, powers_b}, mirrored{beta.exchanged(), powers_b, powers_a};
    LogCell sum{0, 0, 0};
    for (std::size_t s = 0; s < splits_.size(); ++s) {
      LogCell cell = log_probability(s, straight);
      if (!splits_[s].is_even()) cell = either(cell, log_probability(s, mirrored).exchanged());
      sum.log += splits_[s].count * cell.log;
      sum.by_a += splits_[s].count * cell.by_a;
      sum.by_b += splits_[s].count * cell.by_b;
    }
    return sum;
  }

 private:
  struct Law {
    LogBeta beta;
    const CellPowers::Table &left, &right;
  };

  /// That the smaller child is the left one.
  LogCell log_probability(std::size_t s, const Law& law) const {
    const LogBeta& beta = law.beta;
    const double i = static_cast<double>(splits_[s].smaller), j = static_cast<double>(splits_[s].larger);
    const auto& places = sizes_.places[s];
    const double change = std::abs(beta.a - 1) * inverse_size_[places.smaller] +
                          std::abs(beta.b - 1) * inverse_size_[places.larger];
    if (i == 0 || (change > surely_even && panels_needed(beta.a, beta.b, i, j) > 1))
      return log_cell(beta, i, j);
    const LogCell mean = powers_.mean(places, law.left, law.right);
    const double log_n = log_size_[places.node];
    const double x = log_middle_[places.smaller] - log_n, rest = log_middle_[places.larger] - log_n;
    return {(beta.a - 1) * x + (beta.b - 1) * rest + mean.log - log_n - beta.value, x + mean.by_a - beta.by_a,
            rest + mean.by_b - beta.by_b};
  }

  /// The log of the sum of two probabilities.
  static LogCell either(const LogCell& one, const LogCell& other) {
    if (one.log < other.log) return either(other, one);
    const double ratio = std::exp(other.log - one.log), share = ratio / (1 + ratio);
    return {one.log + std::log1p(ratio), one.by_a + share * (other.by_a - one.by_a),
            one.by_b + share * (other.by_b - one.by_b)};
  }

  std::vector<ObservedSplit> splits_;
  SplitSizes sizes_;
  CellPowers powers_;
  std::vector<double> log_size_, log_middle_, inverse_size_;  ///< of every size i: log i, log(i + 1/2), 1/i
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
          .of_splits = beta_likelihood,
          .nested = uniform_shapes()};
}

}  // namespace ramify
