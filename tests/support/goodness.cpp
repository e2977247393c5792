#include "support/goodness.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "support/sanitized.hpp"
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/normal.hpp>

namespace ramify::test {
namespace {

std::string to_text(const Goodness& goodness) {
  std::ostringstream text;
  text << goodness.what << ": statistic " << goodness.statistic;
  if (goodness.degrees > 0) text << ", df " << goodness.degrees;
  text << ", p " << goodness.p_value;
  return text.str();
}

double chi_square_tail(double statistic, double degrees) {
  if (degrees == 0) return 1;
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(degrees), statistic));
}

struct Cell {
  double observed = 0;
  double expected = 0;
  double truth = 0;

  void join(const Cell& other) {
    observed += other.observed;
    expected += other.expected;
    truth += other.truth;
  }
};

/// Neighbours together until each expects `least`; what is left over at the end joins the last cell.
std::vector<Cell> pool(const std::vector<Cell>& fine, double least) {
  std::vector<Cell> cells;
  Cell open;
  for (const Cell& cell : fine) {
    open.join(cell);
    if (open.expected < least) continue;
    cells.push_back(open);
    open = Cell();
  }
  if (cells.empty()) return {open};
  cells.back().join(open);
  return cells;
}

/// What a law expects of so many draws in all.
std::vector<double> scaled_to(double total, std::span<const double> law) {
  const double sum = std::accumulate(law.begin(), law.end(), 0.0);
  std::vector<double> expected;
  for (const double p : law) expected.push_back(total * p / sum);
  return expected;
}

const boost::math::normal standard_normal;
constexpr double doubt = 0.001;  ///< that a power is less than one sample leaves it

double beyond_doubt() {
  return boost::math::quantile(boost::math::complement(standard_normal, doubt));
}

/// Mean and deviation of Pearson's statistic where the cells have other probabilities q than the p that are
/// claimed, by the delta method to second order; of q = p k-1 and sqrt(2(k-1)).
struct StatisticLaw {
  double mean, deviation;
};
StatisticLaw law_of_statistic(const std::vector<Cell>& cells, double Cell::* counts, double total) {
  double mean = 0, slope = 0, slope_square = 0, own = 0, shared = 0;
  for (const Cell& cell : cells) {
    const double p = cell.expected / total, q = cell.*counts / total, off = (q - p) / p;
    mean += q * (1 - q) / p + total * (q - p) * off;
    slope += q * off;
    slope_square += q * off * off;
    own += q * q * (1 - 2 * q) / (p * p);
    shared += q * q / p;
  }
  const double variance = 4 * total * (slope_square - slope * slope) + 2 * (own + shared * shared);
  return {mean, std::sqrt(std::fmax(variance, 0))};
}

double chi_square_power(const Goodness& goodness) {
  const double critical =
      boost::math::quantile(boost::math::complement(boost::math::chi_squared(goodness.degrees), alpha));
  const double mean = goodness.expected.value_or(goodness.statistic - beyond_doubt() * goodness.deviation);
  return boost::math::cdf(standard_normal, (mean - critical) / goodness.deviation);
}

double normal_power(double p_value) {
  if (p_value == 0) return 1;
  const double seen = boost::math::quantile(boost::math::complement(standard_normal, p_value / 2));
  const double critical = boost::math::quantile(boost::math::complement(standard_normal, alpha / 2));
  return boost::math::cdf(standard_normal, seen - beyond_doubt() - critical);
}

/// One impossible draw is enough.
double power_of_impossible(std::uint64_t draws) {
  return -std::expm1(
      -boost::math::quantile(boost::math::gamma_distribution<>(static_cast<double>(draws)), doubt));
}

}  // namespace

::testing::AssertionResult agrees(const Goodness& goodness) {
  std::cout << "  agrees    " << to_text(goodness) << '\n';
  if (goodness.p_value >= alpha) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << to_text(goodness) << " < " << alpha;
}

double least_power(const Goodness& goodness) {
  if (goodness.impossible > 0) return power_of_impossible(goodness.impossible);
  if (goodness.degrees == 0) return normal_power(goodness.p_value);
  return chi_square_power(goodness);
}

::testing::AssertionResult rejected(const Goodness& goodness) {
  const double power = least_power(goodness);
  std::cout << (sanitized ? "  undecided " : "  rejected  ") << to_text(goodness) << ", power " << power
            << '\n';
  if (sanitized) return ::testing::AssertionSuccess();
  if (goodness.p_value >= alpha)
    return ::testing::AssertionFailure() << to_text(goodness) << ": the wrong law passed";
  if (power < needed_power)
    return ::testing::AssertionFailure()
           << to_text(goodness) << ": rejected, but with a power of " << power << " only: take more draws";
  return ::testing::AssertionSuccess();
}

Goodness chi_square(const std::string& what, std::span<const std::uint64_t> observed,
                    std::span<const double> probabilities, double least, std::span<const double> truth) {
  if (observed.size() != probabilities.size()) throw std::invalid_argument("one probability for each count");
  const bool knows_truth = truth.size() == observed.size();
  const double total = std::accumulate(observed.begin(), observed.end(), 0.0);
  const auto expected = scaled_to(total, probabilities);
  const auto true_counts = knows_truth ? scaled_to(total, truth) : expected;
  std::uint64_t impossible = 0;
  std::vector<Cell> fine;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (probabilities[i] == 0) impossible += observed[i];
    fine.push_back({static_cast<double>(observed[i]), expected[i], true_counts[i]});
  }
  if (impossible > 0)
    return {what + " (impossible outcomes)", static_cast<double>(impossible), 0, 0, impossible};
  const auto cells = pool(fine, least);
  double statistic = 0;
  for (const Cell& cell : cells)
    statistic += (cell.observed - cell.expected) * (cell.observed - cell.expected) / cell.expected;
  const double degrees = static_cast<double>(cells.size() - 1);
  const auto law = law_of_statistic(cells, knows_truth ? &Cell::truth : &Cell::observed, total);
  Goodness goodness{what, statistic, degrees, chi_square_tail(statistic, degrees), 0, law.deviation};
  if (knows_truth) goodness.expected = law.mean;
  return goodness;
}

Goodness two_samples(const std::string& what, const Tally& a, const Tally& b) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::pair<double, double>> both;
  double total_a = 0, total_b = 0;
  for (const auto& [outcome, count] : a) {
    both[outcome].first += static_cast<double>(count);
    total_a += static_cast<double>(count);
  }
  for (const auto& [outcome, count] : b) {
    both[outcome].second += static_cast<double>(count);
    total_b += static_cast<double>(count);
  }
  std::vector<std::pair<double, double>> cells;
  std::pair<double, double> rare{0, 0};
  for (const auto& [outcome, counts] : both) {
    const bool few = counts.first + counts.second < 10;
    if (!few) cells.push_back(counts);
    rare.first += few ? counts.first : 0;
    rare.second += few ? counts.second : 0;
  }
  if (rare.first + rare.second >= 10) cells.push_back(rare);
  // Equivalent to Pearson's statistic of the 2 x k table, cell by cell.
  double statistic = 0;
  for (const auto& [x, y] : cells) {
    const double difference = x * std::sqrt(total_b / total_a) - y * std::sqrt(total_a / total_b);
    statistic += difference * difference / (x + y);
  }
  const double degrees = static_cast<double>(cells.size() - 1);
  // Of a noncentral chi-square law with this mean.
  const double deviation = std::sqrt(2 * std::fmax(2 * statistic - degrees, degrees));
  return {what, statistic, degrees, chi_square_tail(statistic, degrees), 0, deviation};
}

void SampleMean::add(double value) {
  count_ += 1;
  const double from_old = value - mean_;
  mean_ += from_old / count_;
  squares_ += from_old * (value - mean_);
}

double SampleMean::standard_error() const {
  return std::sqrt(squares_ / (count_ - 1) / count_);
}

namespace {

Goodness z_test_by(const std::string& what, double mean, double standard_error, double exact) {
  std::ostringstream text;
  text.precision(8);
  text << what << ", mean " << mean << " +- " << standard_error << " for " << exact;
  const double difference = mean - exact;
  if (standard_error == 0) return {text.str(), difference, 0, difference == 0 ? 1.0 : 0.0};
  const double z = difference / standard_error;
  return {text.str(), z, 0,
          2 * boost::math::cdf(boost::math::complement(boost::math::normal(), std::abs(z)))};
}

}  // namespace

Goodness z_test(const std::string& what, const SampleMean& sample, double exact) {
  return z_test_by(what, sample.mean(), sample.standard_error(), exact);
}

Goodness z_test_of_counts(const std::string& what, const SampleMean& sample, double exact) {
  const double above = exact - std::floor(exact);
  const double least = std::sqrt(above * (1 - above) / sample.count());
  return z_test_by(what, sample.mean(), std::max(sample.standard_error(), least), exact);
}

}  // namespace ramify::test
