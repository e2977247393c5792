// Least squares through Ceres against the certified values of NIST (support/nist_data.hpp): from both starts,
// by number of digits in which every parameter agrees. Certified values have 11.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "support/nist_data.hpp"
#include <ceres/jet.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ramify/optimise/least_squares.hpp"

namespace ramify {
namespace {

namespace nist = test::nist;

/// A problem: residuals, both starts, certified values and sum of squares.
struct Problem {
  const char* name;
  Residuals residuals;
  std::vector<Point> starts;
  Point certified;
  double sum_of_squares;
  double least_digits = 9;  ///< fewer where the problem's own condition takes them
};

/// model(b, datum) less y, derivatives by Jets.
template <int parameters, class Model>
Residuals residuals_of(const nist::Data& data, Model model) {
  const auto evaluate = [&data, model](std::span<const double> at, std::span<double> residuals,
                                       double* jacobian) {
    using Jet = ceres::Jet<double, parameters>;
    std::array<Jet, parameters> b;
    for (int k = 0; k < parameters; ++k)
      b[static_cast<std::size_t>(k)] = Jet(at[static_cast<std::size_t>(k)], k);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const Jet value = model(b, data[i]);
      residuals[i] = value.a - data[i].y;
      for (int k = 0; jacobian != nullptr && k < parameters; ++k)
        jacobian[i * parameters + static_cast<std::size_t>(k)] = value.v[k];
    }
    return std::ranges::all_of(residuals, [](double r) { return std::isfinite(r); });
  };
  return {evaluate, data.size()};
}

const nist::Data lanczos2 = [] {
  nist::Data rounded = nist::lanczos1;
  for (auto& [y, x, second] : rounded) y = std::stod(fmt::format("{:.5e}", y));
  return rounded;
}();

/// Logarithms, which are what the problem fits.
const nist::Data log_nelson = [] {
  nist::Data data = nist::nelson;
  for (nist::Datum& datum : data) datum.y = std::log(datum.y);
  return data;
}();

constexpr auto exponentials = [](const auto& b, const nist::Datum& d) {
  return b[0] * exp(-b[1] * d.x) + b[2] * exp(-b[3] * d.x) + b[4] * exp(-b[5] * d.x);
};

constexpr auto saturation = [](const auto& b, const nist::Datum& d) {
  return b[0] * (1.0 - exp(-b[1] * d.x));
};

constexpr auto enso_cycles = [](const auto& b, const nist::Datum& d) {
  const double turn = 2 * std::numbers::pi * d.x;
  return b[0] + b[1] * std::cos(turn / 12) + b[2] * std::sin(turn / 12) + b[4] * cos(turn / b[3]) +
         b[5] * sin(turn / b[3]) + b[7] * cos(turn / b[6]) + b[8] * sin(turn / b[6]);
};

std::vector<Problem> lower_problems() {
  return {
      {"Misra1a",
       residuals_of<2>(nist::misra, saturation),
       {{500, 0.0001}, {250, 0.0005}},
       {2.3894212918E+02, 5.5015643181E-04},
       1.2455138894E-01},
      {"Misra1b",
       residuals_of<2>(nist::misra,
                       [](const auto& b, const auto& d) {
                         return b[0] * (1.0 - 1.0 / ((1.0 + b[1] * d.x / 2.0) * (1.0 + b[1] * d.x / 2.0)));
                       }),
       {{500, 0.0001}, {300, 0.0002}},
       {3.3799746163E+02, 3.9039091287E-04},
       7.5464681533E-02},
      {"Chwirut2",
       residuals_of<3>(nist::chwirut2,
                       [](const auto& b, const auto& d) { return exp(-b[0] * d.x) / (b[1] + b[2] * d.x); }),
       {{0.1, 0.01, 0.02}, {0.15, 0.008, 0.010}},
       {1.6657666537E-01, 5.1653291286E-03, 1.2150007096E-02},
       5.1304802941E+02},
      {"Lanczos3",
       residuals_of<6>(nist::lanczos3, exponentials),
       {{1.2, 0.3, 5.6, 5.5, 6.5, 7.6}, {0.5, 0.7, 3.6, 4.2, 4, 6.3}},
       {8.6816414977E-02, 9.5498101505E-01, 8.4400777463E-01, 2.9515951832E+00, 1.5825685901E+00,
        4.9863565084E+00},
       1.6117193594E-08},
      {"DanWood",
       residuals_of<2>(nist::daniel_wood,
                       [](const auto& b, const auto& d) { return b[0] * exp(b[1] * std::log(d.x)); }),
       {{1, 5}, {0.7, 4}},
       {7.6886226176E-01, 3.8604055871E+00},
       4.3173084083E-03}};
}

std::vector<Problem> average_problems() {
  return {
      {"Kirby2",
       residuals_of<5>(nist::kirby2,
                       [](const auto& b, const auto& d) {
                         return (b[0] + b[1] * d.x + b[2] * d.x * d.x) /
                                (1.0 + b[3] * d.x + b[4] * d.x * d.x);
                       }),
       {{2, -0.1, 0.003, -0.001, 0.00001}, {1.5, -0.15, 0.0025, -0.0015, 0.00002}},
       {1.6745063063E+00, -1.3927397867E-01, 2.5961181191E-03, -1.7241811870E-03, 2.1664802578E-05},
       3.9050739624E+00},
      {"Nelson",
       residuals_of<3>(log_nelson, [](const auto& b,
                                      const auto& d) { return b[0] - b[1] * d.x * exp(-b[2] * d.second); }),
       {{2, 0.0001, -0.01}, {2.5, 0.000000005, -0.05}},
       {2.5906836021E+00, 5.6177717026E-09, -5.7701013174E-02},
       3.7976833176E+00},
      {"MGH17",
       residuals_of<5>(nist::mgh17,
                       [](const auto& b, const auto& d) {
                         return b[0] + b[1] * exp(-d.x * b[3]) + b[2] * exp(-d.x * b[4]);
                       }),
       {{50, 150, -100, 1, 2}, {0.5, 1.5, -1, 0.01, 0.02}},
       {3.7541005211E-01, 1.9358469127E+00, -1.4646871366E+00, 1.2867534640E-02, 2.2122699662E-02},
       5.4648946975E-05},
      {"Lanczos1",
       residuals_of<6>(nist::lanczos1, exponentials),
       {{1.2, 0.3, 5.6, 5.5, 6.5, 7.6}, {0.5, 0.7, 3.6, 4.2, 4, 6.3}},
       {9.5100000027E-02, 1.0000000001E+00, 8.6070000013E-01, 3.0000000002E+00, 1.5575999998E+00,
        5.0000000001E+00},
       1.4307867721E-25},
      {"Lanczos2",
       residuals_of<6>(lanczos2, exponentials),
       {{1.2, 0.3, 5.6, 5.5, 6.5, 7.6}, {0.5, 0.7, 3.6, 4.2, 4, 6.3}},
       {9.6251029939E-02, 1.0057332849E+00, 8.6424689056E-01, 3.0078283915E+00, 1.5529016879E+00,
        5.0028798100E+00},
       2.2299428125E-11},
      {"Misra1c",
       residuals_of<2>(
           nist::misra,
           [](const auto& b, const auto& d) { return b[0] * (1.0 - 1.0 / sqrt(1.0 + 2.0 * b[1] * d.x)); }),
       {{500, 0.0001}, {600, 0.0002}},
       {6.3642725809E+02, 2.0813627256E-04},
       4.0966836971E-02},
      {"Misra1d",
       residuals_of<2>(nist::misra,
                       [](const auto& b, const auto& d) { return b[0] * b[1] * d.x / (1.0 + b[1] * d.x); }),
       {{500, 0.0001}, {450, 0.0003}},
       {4.3736970754E+02, 3.0227324449E-04},
       5.6419295283E-02},
      {"Roszman1",
       residuals_of<4>(nist::roszman1,
                       [](const auto& b, const auto& d) {
                         const auto quotient = b[2] / (d.x - b[3]);
                         return b[0] - b[1] * d.x -
                                atan2(quotient, decltype(quotient)(1.0)) / std::numbers::pi;
                       }),
       {{0.1, -0.00001, 1000, -100}, {0.2, -0.000005, 1200, -150}},
       {2.0196866396E-01, -6.1953516256E-06, 1.2044556708E+03, -1.8134269537E+02},
       4.9484847331E-04},
      {"ENSO",
       residuals_of<9>(nist::enso, enso_cycles),
       {{11, 3, 0.5, 40, -0.7, -1.3, 25, -0.3, 1.4}, {10, 3, 0.5, 44, -1.5, 0.5, 26, -0.1, 1.5}},
       {1.0510749193E+01, 3.0762128085E+00, 5.3280138227E-01, 4.4311088700E+01, -1.6231428586E+00,
        5.2554493756E-01, 2.6887614440E+01, 2.1232288488E-01, 1.4966870418E+00},
       7.8853978668E+02}};
}

std::vector<Problem> higher_problems() {
  return {{"MGH09",
           residuals_of<4>(nist::mgh09,
                           [](const auto& b, const auto& d) {
                             return b[0] * (d.x * d.x + d.x * b[1]) / (d.x * d.x + d.x * b[2] + b[3]);
                           }),
           {{25, 39, 41.5, 39}, {0.25, 0.39, 0.415, 0.39}},
           {1.9280693458E-01, 1.9128232873E-01, 1.2305650693E-01, 1.3606233068E-01},
           3.0750560385E-04},
          {"Thurber",
           residuals_of<7>(nist::thurber,
                           [](const auto& b, const auto& d) {
                             return (b[0] + d.x * (b[1] + d.x * (b[2] + d.x * b[3]))) /
                                    (1.0 + d.x * (b[4] + d.x * (b[5] + d.x * b[6])));
                           }),
           {{1000, 1000, 400, 40, 0.7, 0.3, 0.03}, {1300, 1500, 500, 75, 1, 0.4, 0.05}},
           {1.2881396800E+03, 1.4910792535E+03, 5.8323836877E+02, 7.5416644291E+01, 9.6629502864E-01,
            3.9797285797E-01, 4.9727297349E-02},
           5.6427082397E+03},
          {"BoxBOD",
           residuals_of<2>(nist::box_bod, saturation),
           {{1, 1}, {100, 0.75}},
           {2.1380940889E+02, 5.4723748542E-01},
           1.1680088766E+03},
          {"Rat42",
           residuals_of<3>(nist::rat42, [](const auto& b,
                                           const auto& d) { return b[0] / (1.0 + exp(b[1] - b[2] * d.x)); }),
           {{100, 1, 0.1}, {75, 2.5, 0.07}},
           {7.2462237576E+01, 2.6180768402E+00, 6.7359200066E-02},
           8.0565229338E+00},
          {"MGH10",
           residuals_of<3>(nist::mgh10,
                           [](const auto& b, const auto& d) { return b[0] * exp(b[1] / (d.x + b[2])); }),
           {{2, 400000, 25000}, {0.02, 4000, 250}},
           {5.6096364710E-03, 6.1813463463E+03, 3.4522363462E+02},
           8.7945855171E+01},
          {"Eckerle4",
           residuals_of<3>(nist::eckerle4,
                           [](const auto& b, const auto& d) {
                             return b[0] / b[1] * exp(-0.5 * (d.x - b[2]) * (d.x - b[2]) / (b[1] * b[1]));
                           }),
           {{1, 10, 500}, {1.5, 5, 450}},
           {1.5543827178E+00, 4.0888321754E+00, 4.5154121844E+02},
           1.4635887487E-03},
          {"Rat43",
           residuals_of<4>(nist::rat43,
                           [](const auto& b, const auto& d) {
                             return b[0] / exp(log(1.0 + exp(b[1] - b[2] * d.x)) / b[3]);
                           }),
           {{100, 10, 1, 1}, {700, 5, 0.75, 1.3}},
           {6.9964151270E+02, 5.2771253025E+00, 7.5962938329E-01, 1.2792483859E+00},
           8.7864049080E+03}};
}

double digits(double found, double certified) {
  const double off = std::abs(found - certified) / std::abs(certified);
  return std::clamp(-std::log10(off), 0.0, 11.0);
}

void expect_certified(const std::vector<Problem>& problems) {
  for (const Problem& problem : problems)
    for (std::size_t start = 0; start < problem.starts.size(); ++start) {
      const LeastSquares fit = least_squares(problem.residuals, problem.starts[start]);
      double least = 11;
      for (std::size_t i = 0; i < fit.at.size(); ++i)
        least = std::min(least, digits(fit.at[i], problem.certified[i]));
      const std::string name = fmt::format("{} start {}", problem.name, start + 1);
      testing::Test::RecordProperty(fmt::format("{}_{}_digits", problem.name, start + 1),
                                    fmt::format("{:.1f}", least));
      fmt::print("{:18} {:4.1f} digits, sum of squares {:.10e}\n", name, least, fit.sum_of_squares);
      EXPECT_TRUE(fit.converged) << name;
      EXPECT_GE(least, problem.least_digits) << name;
      EXPECT_GE(digits(fit.sum_of_squares, problem.sum_of_squares), problem.sum_of_squares > 1e-20 ? 9 : 0)
          << name;
    }
}

TEST(OptimiseNist, LowerDifficulty) {
  expect_certified(lower_problems());
}

TEST(OptimiseNist, AverageDifficulty) {
  expect_certified(average_problems());
}

TEST(OptimiseNist, HigherDifficulty) {
  expect_certified(higher_problems());
}

/// Certified standard deviations: from the covariance, residuals in units of their own deviation.
TEST(OptimiseNist, CovarianceIsThatOfTheCertifiedDeviations) {
  const auto expect_deviations = [](const Problem& problem, const Point& deviations) {
    const LeastSquares fit = least_squares(problem.residuals, problem.starts[1]);
    const double degrees = static_cast<double>(problem.residuals.count - fit.at.size());
    ASSERT_FALSE(fit.covariance.empty()) << problem.name;
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      const double deviation = std::sqrt(fit.variance(i) * fit.sum_of_squares / degrees);
      EXPECT_GE(digits(deviation, deviations[i]), 7) << problem.name << ' ' << i;
    }
  };
  expect_deviations(lower_problems()[0], {2.7070075241E+00, 7.2668688436E-06});
  expect_deviations(lower_problems()[2], {3.8303286810E-02, 6.6621605126E-04, 1.5304234767E-03});
  expect_deviations(higher_problems()[1],
                    {4.6647963344E+00, 3.9571156086E+01, 2.8698696102E+01, 5.5675370270E+00, 3.1333340687E-02,
                     1.4984928198E-02, 6.5842344623E-03});
}

TEST(OptimiseLeastSquares, HasNoCovarianceWhereAParameterHasNoHold) {
  const auto evaluate = [](std::span<const double> at, std::span<double> residuals, double* jacobian) {
    for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] = at[0] - static_cast<double>(i);
    for (std::size_t i = 0; jacobian != nullptr && i < 2 * residuals.size(); ++i) jacobian[i] = i % 2 == 0;
    return true;
  };
  const LeastSquares fit = least_squares({evaluate, 5}, {0, 3});
  EXPECT_NEAR(fit.at[0], 2, 1e-12);
  EXPECT_TRUE(fit.covariance.empty());
}

}  // namespace
}  // namespace ramify
