// Draws docs/theory/bst_height: what is left of the mean height of random binary search trees when its two
// growing terms are taken off, to n = 10^300. Prints what it draws, and the local slopes beside those of
// front theory.
//   height_figure docs/theory
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "ramify/large/large_law.hpp"
#include "ramify/model/registry.hpp"
#include "ramify/report/plot.hpp"
#include "ramify/statistic/registry.hpp"

namespace {

using namespace ramify;

// Devroye 1986 and Reed 2003: E H_n = alpha log n - beta log log n + O(1); alpha log(2e/alpha) = 1, beta = 3
// alpha/(2 alpha - 2).
constexpr double alpha = 4.311070407, beta = 1.953025703;

constexpr double last_decade = 300;

double left_over(double n, double mean) {
  return mean - alpha * std::log(n) + beta * std::log(std::log(n));
}

/// Of E H over log n between n/e^2 and n.
double local_slope(const LargeLaw& heights, double n) {
  return (heights.moments(n).mean.value - heights.moments(n * std::exp(-2.0)).mean.value) / 2;
}

Plot height_plot(const LargeLaw& heights) {
  Plot plot{
      "Height of random binary search trees",
      "mean, by its recurrence, minus 4.311070407 log n plus 1.953025703 log log n: bounded (Reed 2003)",
      "log10 n (internal nodes)",
      "E H_n minus its growing terms",
      false,
      false};
  PlotSeries series{"bst, height in nodes"};
  fmt::print("n,mean_height,error,left_over\n");
  for (double decade = 4; decade <= last_decade; decade += decade < 20 ? 0.25 : 2) {
    const double n = std::pow(10.0, decade);
    const Approximation mean = heights.moments(n).mean;
    series.curve.push_back({decade, left_over(n, mean.value)});
    fmt::print("{:.5g},{:.12g},{:.1g},{:.9f}\n", n, mean.value, mean.error, left_over(n, mean.value));
  }
  plot.series.push_back(series);
  return plot;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "height_figure: give the folder to draw into, such as docs/theory\n");
    return 2;
  }
  std::vector<double> sizes;
  for (const double decade : {4.0, 9.0, 30.0, 100.0, 200.0, last_decade})
    sizes.push_back(std::pow(10.0, decade));
  const LargeLaw heights(Model::parse("bst"), statistic::height.law.recurrence, sizes);
  const PlotFiles files = write_plot(height_plot(heights), argv[1], "bst_height");
  for (const double decade : {100.0, 200.0, last_decade}) {
    const double n = std::pow(10.0, decade), middle = std::log(n) - 1;
    const double front = alpha - beta / middle, slope = local_slope(heights, n);
    fmt::print("slope at n = {:.0e}: {:.6f}, front theory {:.6f} + {:.2f} (log n)^(-3/2)\n", n, slope, front,
               (slope - front) * std::pow(middle, 1.5));
  }
  if (files.status == PlotStatus::drawn) return 0;
  fmt::print(stderr, "height_figure: no picture: {}\n", files.message);
  return 1;
}
