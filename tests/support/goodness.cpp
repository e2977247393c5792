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
};

/// Neighbours together until each expects `least`; what is left over at the end joins the last cell.
std::vector<Cell> pool(std::span<const std::uint64_t> observed, std::span<const double> expected,
                       double least) {
  std::vector<Cell> cells;
  Cell open;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    open.observed += static_cast<double>(observed[i]);
    open.expected += expected[i];
    if (open.expected < least) continue;
    cells.push_back(open);
    open = Cell();
  }
  if (cells.empty()) return {open};
  cells.back().observed += open.observed;
  cells.back().expected += open.expected;
  return cells;
}

}  // namespace

::testing::AssertionResult agrees(const Goodness& goodness) {
  std::cout << "  agrees    " << to_text(goodness) << '\n';
  if (goodness.p_value >= alpha) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << to_text(goodness) << " < " << alpha;
}

::testing::AssertionResult rejected(const Goodness& goodness) {
  std::cout << (sanitized ? "  undecided " : "  rejected  ") << to_text(goodness) << '\n';
  if (sanitized || goodness.p_value < alpha) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << to_text(goodness) << ": the wrong law passed";
}

Goodness chi_square(const std::string& what, std::span<const std::uint64_t> observed,
                    std::span<const double> probabilities, double least) {
  if (observed.size() != probabilities.size()) throw std::invalid_argument("one probability for each count");
  const double total = std::accumulate(observed.begin(), observed.end(), 0.0);
  const double sum = std::accumulate(probabilities.begin(), probabilities.end(), 0.0);
  std::vector<double> expected;
  for (const double p : probabilities) expected.push_back(total * p / sum);
  for (std::size_t i = 0; i < observed.size(); ++i)
    if (observed[i] > 0 && probabilities[i] == 0)
      return {what + " (an impossible outcome)", std::numeric_limits<double>::infinity(), 0, 0};
  const auto cells = pool(observed, expected, least);
  double statistic = 0;
  for (const Cell& cell : cells)
    statistic += (cell.observed - cell.expected) * (cell.observed - cell.expected) / cell.expected;
  const double degrees = static_cast<double>(cells.size() - 1);
  return {what, statistic, degrees, chi_square_tail(statistic, degrees)};
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
  return {what, statistic, degrees, chi_square_tail(statistic, degrees)};
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
